#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/plan.hpp"

#include <string>

namespace simreel::sim {

/// Part of a kernel interface: inputs of glsl/cloth/thin_kernel.glsl, used by every kernel that computes
/// displacements by thin colliders.
struct ThinPart {
  gl::Block<"StepBlock", shader::ClothStep> step;
  gl::In<"positions"> before;
  gl::In<"nextPositions"> next;
  gl::In<"velocities"> velocities;
  gl::Out<"shifts"> shifts;
};

struct ThinShift;

/// Collisions with colliders that are thinner than the spacing of a cloth's mesh (glsl/cloth/thin.glsl).
/// Edges and faces are tested at the end of a substep, and their vertices are displaced.
class ThinColliders {
 public:
  ThinColliders() = default;
  /// Creates the buffers for a cloth of `vertices` vertices and `count` thin colliders; creates nothing if
  /// `count` is 0.
  ThinColliders(const std::string& name, int count, int vertices, bool fast);

  [[nodiscard]] bool any() const { return any_; }
  /// Resolves the collisions in several rounds. In each round, `find` dispatches the kernel that computes
  /// the changes of `next` and `velocities`, and move() applies them.
  template <class Find>
  void resolveThin(const gl::Resource& step, const gl::Vec4Array& before, const gl::Vec4Array& next,
                   const gl::Vec4Array& velocities, const Find& find) const {
    for (int round = 0; any_ && round < rounds; ++round) {
      find(ThinPart{step, before, next, velocities, shifts_});
      move(next, velocities);
    }
  }

 private:
  static const int rounds;
  void move(const gl::Vec4Array& next, const gl::Vec4Array& velocities) const;

  bool any_ = false;
  int vertices_ = 0;
  gl::Vec4Array shifts_;
  gl::Kernel<ThinShift> move_;
};

}  // namespace simreel::sim
