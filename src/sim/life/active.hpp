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

/// Advances a small grid by many generations per dispatch and computes only tiles near cells that change
/// (glsl/life/active.comp). It is meant for drivers on the CPU, where a workgroup is a thread. LifeStepper
/// parallelizes larger grids better.
class LifeActive {
 public:
  /// Number of generations per pass.
  static constexpr int steps = 8;
  /// Minimum number of generations for which this class is faster, although it copies the cells and
  /// computes every tile once.
  static constexpr int minGenerations = 256;

  /// Returns true if the current device and the grid size are suitable: a software driver, at most 2^18
  /// cells, rows of whole 32-bit words, and at least as many rows as a tile has.
  [[nodiscard]] static bool suits(glm::ivec2 size);

  LifeActive(const CellRule& rule, bool torus, glm::ivec2 size);

  /// Runs `passes` passes of `steps` generations in place. Earlier writes must be visible (gl::barrier);
  /// the results are visible on return, because the cells are copied. Marks `status`
  /// (glsl/common/status.glsl) as lost if the driver ended a loop early.
  void run(gl::WordsArray& cells, int passes, const gl::Buffer& status);

 private:
  glm::ivec2 size_;
  int words_;              ///< number of 32-bit words in the grid
  int passesPerDispatch_;  ///< maximum number of passes per dispatch for which the driver does not end a
                           ///< loop early
  unsigned pass_ = 0;
  gl::Buffer cells_;  ///< cells before a pass and cells after it, in the two halves of the buffer
  gl::Texture texels_;
  gl::Buffer marks_;
  gl::Kernel<LifeActiveKernel> kernel_;
};

}  // namespace simreel::sim
