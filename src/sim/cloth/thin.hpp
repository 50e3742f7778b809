#pragma once
#include "gl/element_array.hpp"
#include "gl/program.hpp"

#include <string>

namespace simreel::sim {

/// Colliders thinner than a cloth's mesh is wide: what its vertices get of them (glsl/cloth/thin.glsl),
/// after all else of a substep.
class ThinColliders {
 public:
  ThinColliders() = default;
  /// `path` of the kernel that finds it, for a cloth of so many vertices; nothing is made where `count` is
  /// 0.
  ThinColliders(const std::string& name, const char* path, int count, int vertices, bool fast);

  [[nodiscard]] bool there() const { return there_; }
  /// For what it needs besides.
  [[nodiscard]] const gl::Program& kernel() const { return find_; }
  /// Where the vertices were and go, and their speeds, which change; the step's block is bound, and what
  /// the kernel reads besides. `x` by `y` invocations.
  void fend(const gl::Vec4Array& before, const gl::Vec4Array& next, const gl::Vec4Array& velocities, int x,
            int y) const;

 private:
  bool there_ = false;
  int vertices_ = 0;
  gl::Vec4Array shifts_;
  gl::Program find_, move_;
};

}  // namespace simreel::sim
