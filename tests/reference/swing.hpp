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
  double degrees = 0;  ///< angle in degrees at release; 0 is straight down
  double length = 0;   ///< length of the cloth in metres, from the pins down
};

/// Test cases: a grid of springs, a fabric and a strip of triangles. Each is 1 m long and 0.5 m wide.
/// `spacing` is in metres.
[[nodiscard]] Case springs(double degrees, double spacing);
[[nodiscard]] Case fabric(double degrees, double spacing);
[[nodiscard]] Case strip(double degrees, double spacing);

/// Energy of a swing over time, as a fraction. It is 1 at release, and 0 when the cloth hangs at rest.
struct Course {
  /// Means over one swing each, in order of time. The first swing is left out.
  std::vector<double> means;
  double rise = 0;  ///< maximum amount by which a mean exceeds an earlier one
  [[nodiscard]] double drift() const { return means.back() - means.front(); }
};

/// Measures a case over `seconds`. `energyAfter` must step one frame and return the quantity "energy" in
/// joules.
[[nodiscard]] Course courseOf(const Case& given, double seconds,
                              const std::function<double()>& energyAfter);

/// Measures a case with the CPU twin, which equals the GPU bit for bit.
[[nodiscard]] Course courseOfTwin(const Case& given, double seconds);

}  // namespace simreel::swing
