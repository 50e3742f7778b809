#pragma once
#include "sim/cloth/parameters.hpp"

#include <functional>
#include <string>
#include <vector>

/// Cloth pinned along its upper border, released at an angle, swinging without damping, wind or air: tests
/// how its energy develops.
namespace simreel::swing {

struct Case {
  std::string name;
  sim::ClothParameters parameters;
  double degrees = 0;  ///< angle in degrees from hanging down to the start
  double length = 0;   ///< length in m, from the pins down
};

/// A grid of springs, a fabric, a strip of triangles; each 1 m long and half as wide. `spacing` is in m.
[[nodiscard]] Case springs(double degrees, double spacing);
[[nodiscard]] Case fabric(double degrees, double spacing);
[[nodiscard]] Case strip(double degrees, double spacing);

/// The remaining energy of a swing; 1 is the start's energy above hanging at rest.
struct Course {
  /// Means over successive periods of the swing, without the first.
  std::vector<double> means;
  double rise = 0;  ///< maximum increase of a mean above an earlier one
  [[nodiscard]] double drift() const { return means.back() - means.front(); }
};

/// Runs a case; `energyAfter` simulates a frame and returns the quantity "energy" (J).
[[nodiscard]] Course courseOf(const Case& given, double seconds,
                              const std::function<double()>& energyAfter);

/// Runs a case with the CPU twin, which gives the device's bits.
[[nodiscard]] Course courseOfTwin(const Case& given, double seconds);

}  // namespace simreel::swing
