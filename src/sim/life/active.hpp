#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <optional>

#include <glm/vec2.hpp>

namespace simreel::sim {

struct LifeActiveKernel;

/// Advances a small grid by many generations a dispatch, computing only tiles near something that moves
/// (glsl/life/active.comp). For drivers on the CPU, where one work group is one thread: much work is better
/// shared by LifeStepper's.
class LifeActive {
 public:
  /// Generations in one pass.
  static constexpr int steps = 8;
  /// Fewer generations than this are not worth copying the cells and computing every tile once.
  static constexpr int minGenerations = 256;

  /// Whether the present device and a grid of this size suit it: software drivers; at most 2^18 cells, rows
  /// of whole words, at least as high as a tile.
  [[nodiscard]] static bool suits(glm::ivec2 size);

  LifeActive(const CellRule& rule, bool torus, glm::ivec2 size);

  /// `passes` passes of `steps` generations, in place. Earlier writes must be visible (gl::barrier), and so
  /// are those of this when it returns: cells are copied. `status` (glsl/common/status.glsl) is noted lost
  /// where the driver ended a loop before its end.
  void run(gl::WordsArray& cells, int passes, const gl::Buffer& status);

 private:
  glm::ivec2 size_;
  int words_;              ///< of the grid
  int passesPerDispatch_;  ///< so that no loop is cut off
  unsigned pass_ = 0;
  gl::Buffer cells_;  ///< both halves: before and after a pass
  gl::Texture texels_;
  gl::Buffer marks_;
  gl::Kernel<LifeActiveKernel> kernel_;
};

}  // namespace simreel::sim
