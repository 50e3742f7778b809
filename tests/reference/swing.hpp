#pragma once
#include "sim/cloth/parameters.hpp"

#include <functional>
#include <string>
#include <vector>

/// Cloth that is pinned along its upper border, let go at an angle, and swings without damping, wind or
/// air: what becomes of its energy.
namespace simreel::swing {

struct Case {
  std::string name;
  sim::ClothParameters parameters;
  double degrees = 0;  ///< from hanging to where it is let go
  double length = 0;   ///< m, from the pins down
};

/// A grid of springs, a fabric, a strip of triangles, each 1 m long and half as wide. `spacing`: m.
[[nodiscard]] Case springs(double degrees, double spacing);
[[nodiscard]] Case fabric(double degrees, double spacing);
[[nodiscard]] Case strip(double degrees, double spacing);

/// What is left of the energy of a swing, 1 of all of it: the start against hanging at rest.
struct Course {
  /// Means over a swing each, one after the other, without the first.
  std::vector<double> means;
  double rise = 0;  ///< most by which a mean is above one before it
  [[nodiscard]] double drift() const { return means.back() - means.front(); }
};

/// `energyAfter` steps a frame and gives the quantity "energy" (J).
[[nodiscard]] Course courseOf(const Case& given, double seconds,
                              const std::function<double()>& energyAfter);

/// By the CPU twin, which has the device's bits.
[[nodiscard]] Course courseOfTwin(const Case& given, double seconds);

}  // namespace simreel::swing
