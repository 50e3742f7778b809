#pragma once
#include "glsl/common/cpp.hpp"
#include "sim/core/collider.hpp"

#include <array>
#include <span>
#include <vector>

namespace simreel::shader {
#include "glsl/collide/types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Fraction of a quantity left after `seconds` when it decays at `rate` (1/s).
[[nodiscard]] float keptOf(float rate, double seconds);

/// What those that touch the shapes of a scene are told of them, substep by substep; shared with the CPU
/// twins.
class ColliderPlan {
 public:
  /// Throws UserError(usage) when there are more than the kernels hold; `who` ("a cloth") stands in the
  /// message.
  ColliderPlan(const char* who, std::vector<ColliderShape> shapes, int substeps, double substepSeconds);

  [[nodiscard]] int count() const { return static_cast<int>(shapes_.size()); }
  /// Whether it passes between vertices that are `edge` (m) apart, `margin` (m) around it included: a rod
  /// thinner than that, or a ball that fits between four.
  static bool isThin(const ColliderShape& shape, double edge, double margin);
  /// Puts those last that do. Returns how many they are.
  int putThinLast(double edge, double margin);
  /// Of each substep of the frame that starts at `time` (s): its colliders at its end, count() of them.
  [[nodiscard]] std::vector<std::vector<shader::Collider>> frame(double time) const;

 private:
  [[nodiscard]] shader::Collider keyedAt(const ColliderShape& shape, double time) const;
  [[nodiscard]] shader::Collider carriedIn(const ColliderShape& shape,
                                           const std::array<CarriedCapsule, 2>& ends, int substep) const;

  std::vector<ColliderShape> shapes_;
  int substeps_;
  double substepSeconds_;
};

}  // namespace simreel::sim
