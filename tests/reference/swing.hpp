#pragma once
#include "sim/cloth/parameters.hpp"

#include <functional>
#include <string>
#include <vector>

/// Measures the energy of a cloth that is pinned along its upper border, released at an angle, and swings
/// without damping, wind or air.
namespace simreel::swing {

struct Case {
  std::string name;
  sim::ClothParameters parameters;
  double degrees = 0;  ///< angle at release, from hanging straight down
  double length = 0;   ///< metres, from the pins down
};

/// Test cases: a grid of springs, a fabric and a strip of triangles, each 1 m long and 0.5 m wide.
/// `spacing`: metres.
/// metres.
[[nodiscard]] Case springs(double degrees, double spacing);
[[nodiscard]] Case fabric(double degrees, double spacing);
[[nodiscard]] Case strip(double degrees, double spacing);

/// The remaining swing energy as a fraction: 1 at release, 0 when hanging at rest.
struct Course {
  /// Consecutive means over one swing each, without the first swing.
  std::vector<double> means;
  double rise = 0;  ///< max amount by which a mean exceeds an earlier mean
  [[nodiscard]] double drift() const { return means.back() - means.front(); }
};

/// Measures a case over `seconds`. `energyAfter` steps one frame and returns the quantity "energy" in
/// joules.
[[nodiscard]] Course courseOf(const Case& given, double seconds,
                              const std::function<double()>& energyAfter);

/// Measures the case with the CPU twin, which equals the GPU bit for bit.
[[nodiscard]] Course courseOfTwin(const Case& given, double seconds);

}  // namespace simreel::swing
