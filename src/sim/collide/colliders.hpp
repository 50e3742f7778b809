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

/// Returns the fraction of a quantity that remains after an exponential decay at `rate` (1/s) over
/// `seconds`.
[[nodiscard]] float keptOf(float rate, double seconds);

/// Computes the colliders' data for each substep. The CPU references use it, too.
class ColliderPlan {
 public:
  /// Throws UserError(usage) if there are more shapes than the kernels support. `kindName` (such as "a
  /// cloth") appears in the message.
  ColliderPlan(const char* kindName, std::vector<ColliderShape> shapes, int substeps,
               double substepSeconds);

  [[nodiscard]] int count() const { return static_cast<int>(shapes_.size()); }
  /// Returns true if the shape, enlarged by `margin` (metres), could pass between vertices that are `edge`
  /// (metres) apart. That is so for a rod thinner than `edge` and for a sphere that fits between four
  /// vertices.
  static bool isThin(const ColliderShape& shape, double edge, double margin);
  /// Moves all thin shapes (see isThin()), and all shapes whose radius plus margin is below `minimum`
  /// (metres), to the end of the list. Returns the number of shapes moved.
  int putThinLast(double edge, double margin, double minimum = 0);
  /// Returns the colliders at the end of each substep of the frame that starts at `time` (seconds), count()
  /// per substep.
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
