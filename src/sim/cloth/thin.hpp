#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/plan.hpp"

#include <string>

namespace simreel::sim {

/// What glsl/cloth/thin_kernel.glsl is given, a part of the interface of a kernel that finds shifts.
struct ThinPart {
  gl::Block<"StepBlock", shader::ClothStep> step;
  gl::In<"positions"> before;
  gl::In<"nextPositions"> next;
  gl::In<"velocities"> velocities;
  gl::Out<"shifts"> shifts;
};

struct ThinShift;

/// Colliders thinner than a cloth's mesh is wide: what its vertices get of them (glsl/cloth/thin.glsl),
/// after all else of a substep.
class ThinColliders {
 public:
  ThinColliders() = default;
  /// For a cloth of so many vertices; nothing is made where `count` is 0.
  ThinColliders(const std::string& name, int count, int vertices, bool fast);

  [[nodiscard]] bool there() const { return there_; }
  /// `find` dispatches the kernel that finds the shifts of `next` and of its `velocities`, which then move.
  template <class Find>
  void fend(const gl::Resource& step, const gl::Vec4Array& before, const gl::Vec4Array& next,
            const gl::Vec4Array& velocities, const Find& find) const {
    for (int round = 0; there_ && round < rounds; ++round) {
      find(ThinPart{step, before, next, velocities, shifts_});
      move(next, velocities);
    }
  }

 private:
  static const int rounds;
  void move(const gl::Vec4Array& next, const gl::Vec4Array& velocities) const;

  bool there_ = false;
  int vertices_ = 0;
  gl::Vec4Array shifts_;
  gl::Kernel<ThinShift> move_;
};

}  // namespace simreel::sim
