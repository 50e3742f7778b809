#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/spread/plan.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace simreel::sim {

/// Packs the cells of a grid (x fastest) for the kernels. Byte cells are packed four per word and sixteen
/// per uvec4 element; cells of two bytes are packed half as many. Each row is padded with zeros to whole
/// elements.
[[nodiscard]] std::vector<glm::uvec4> packedCells(const std::vector<std::uint8_t>& cells, glm::ivec2 size);
[[nodiscard]] std::vector<glm::uvec4> packedCells(const std::vector<std::uint16_t>& cells, glm::ivec2 size);

/// Parts of kernel interfaces: inputs common to all kernels spread/*/step.comp, and inputs common to all
/// kernels spread/*/paint.comp.
struct SpreadStepPart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"torus", bool> torus;
  gl::Uniform<"countPlace", int> countPlace;
  gl::Uniform<"fresh", bool> fresh;
  gl::In<"cells"> cells;
  gl::Out<"nextCells"> next;
  gl::InOut<"CountBlock"> counts;
  gl::In<"tiles"> tiles;
  gl::Out<"NextTileBlock"> nextTiles;
};
struct SpreadPaintPart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Uniform<"countPlace", int> countPlace;
  StrokeUniforms stroke;
  gl::In<"stamps"> stamps;
  gl::InOut<"cells"> cells;
  gl::InOut<"CountBlock"> counts;
};

/// Owns the GPU grid of an epidemic or a wildfire, with two bytes per cell, and the counts of every step so
/// far. Dispatches the kernels in glsl/spread.
class SpreadGrid {
 public:
  /// Throws UserError(device), naming the limit, if a grid of this size exceeds a limit. Call it before
  /// buffers are filled. `bytesPerCell` applies to the largest buffer.
  static void checkLimits(const std::string& name, glm::ivec2 size, int bytesPerCell = 1);

  SpreadGrid(const std::string& name, const SpreadParameters& parameters,
             const std::vector<std::uint8_t>& cells, int stepsPerFrame, const Strokes& strokes);

  /// Runs the steps of a frame. Each step applies the rule and then the strokes that paint into its result;
  /// its counts include the strokes. `blocks` receives the uniform data of the steps. `kernels` dispatches
  /// both kernels: step(items, SpreadStepPart, block) and paint(items, SpreadPaintPart, block). Calls
  /// `watch` `stepsPerFrame` times, even if this frame has one step less.
  template <class Step, class Kernels>
  void runFrame(const std::vector<Step>& steps, StepBlocks<decltype(Step::data)>& blocks, int stepsPerFrame,
                const StepWatch& watch, const Kernels& kernels) {
    blocks.upload(steps, &Step::data);
    beginFrame(static_cast<int>(steps.size()));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const gl::Resource uniforms = blocks.at(i);
      const SpreadStepPart given = beginStep();
      kernels.step(glm::ivec2(rowElements(), groupRows()), given, uniforms);
      endStep();
      paint(steps[i].strokes, uniforms, kernels);
      if (watch) watch(static_cast<int>(i) + 1);
    }
    endFrame();
    if (!watch) return;
    for (int i = static_cast<int>(steps.size()); i < stepsPerFrame; ++i) watch(i + 1);
  }
  /// Applies strokes to the initial state.
  template <class Kernels>
  void paintFirst(const std::vector<shader::Stroke>& strokes, const gl::Resource& uniforms,
                  const Kernels& kernels) {
    paint(strokes, uniforms, kernels);
    if (!strokes.empty()) startPainted();
  }

  void visitCheckpointData(CarryOver& carry);

  [[nodiscard]] const gl::WordsArray& cells() const { return cells_[0]; }
  [[nodiscard]] int rowElements() const { return (size_.x + 15) / 16; }
  /// Returns the counts of the current frame with one row per step. Before the first step, there is one row
  /// with the initial counts.
  [[nodiscard]] const gl::Buffer& frameCounts() const { return frameCounts_; }
  [[nodiscard]] int frameSteps() const { return frameSteps_; }
  /// Reads back the four counts of the current state. Waits for the GPU.
  [[nodiscard]] glm::uvec4 latestCounts() const;
  /// Returns the name of a state element, for example "cells (16, 3) to (31, 3)".
  [[nodiscard]] std::string elementName(long element) const;

  using ClassNames = std::vector<std::pair<int, std::string>>;
  void publishField(const std::string& name, const std::vector<glm::vec3>& colors,
                    const ClassNames& classes, const FieldDisplay& display, Drawables& drawables) const;
  /// Adds a chart of the counts so far. It shows the first names.size() counts.
  void publishChart(const std::vector<std::string>& names, const std::vector<glm::vec3>& colors,
                    double steps, Drawables& drawables) const;

 private:
  /// Reserves space for the counts of `steps` more steps.
  void beginFrame(int steps);
  /// Returns the number of rows of invocations in a step's dispatch.
  [[nodiscard]] int groupRows() const;
  /// Returns the kernel inputs of the next step.
  SpreadStepPart beginStep();
  void endStep();
  template <class Kernels>
  void paint(const std::vector<shader::Stroke>& strokes, const gl::Resource& uniforms,
             const Kernels& kernels) {
    for (const shader::Stroke& stroke : strokes) {
      const glm::ivec4 box = Strokes::box(stroke, size_);
      if (box.z <= 0 || box.w <= 0) continue;
      const int first = box.x / 16;
      const glm::ivec4 elements(first, box.y, (box.x + box.z + 15) / 16 - first, box.w);
      kernels.paint(glm::ivec2(elements.z, elements.w),
                    SpreadPaintPart{.size = size_,
                                    .countPlace = done_,
                                    .stroke = uniformsOf(stroke, elements),
                                    .stamps = stamps_,
                                    .cells = cells_[0],
                                    .counts = history_.buffer()},
                    uniforms);
      fresh_ = true;
    }
  }
  /// Updates the initial counts after strokes were painted.
  void startPainted();
  /// Copies the frame's counts to the buffer that frameCounts() returns, and makes the state visible to all
  /// later commands.
  void endFrame();

  std::string name_;
  glm::ivec2 size_;
  bool torus_;
  gl::WordsArray cells_[2];  ///< current cells, and the output of the next step
  gl::WordsArray history_;   ///< counts of every step, starting with the initial counts; has space for
                             ///< capacity_ rows
  gl::WordsArray stamps_;
  /// Activity of each tile on the texel path (glsl/spread/tiles.glsl): after the last step, and the output
  /// of the next step. Both are invalid after a start, a restart or a stroke (fresh_).
  gl::WordsArray tiles_[2];
  bool fresh_ = true;
  gl::Buffer frameCounts_;
  int capacity_ = 0;
  int done_ = 0;
  int frameStart_ = 0;
  int frameSteps_ = 1;
  unsigned max_ = 1;  ///< initial number of people or of fuel cells
};

}  // namespace simreel::sim
