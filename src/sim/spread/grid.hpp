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

/// Cells of a grid, x fastest, as the kernels want them: four a word, sixteen an element, each row filled
/// up with zeros to whole elements; of two bytes a cell, half as many.
[[nodiscard]] std::vector<glm::uvec4> packedCells(const std::vector<std::uint8_t>& cells, glm::ivec2 size);
[[nodiscard]] std::vector<glm::uvec4> packedCells(const std::vector<std::uint16_t>& cells, glm::ivec2 size);

/// Parts of the interfaces of spread/*/step.comp and paint.comp that are the same for all.
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

/// The grid of an epidemic or a wildfire on the GPU: two bytes a cell, the counts of every step so far, and
/// what runs the kernels of glsl/spread.
class SpreadGrid {
 public:
  /// Before anything is filled: throws UserError(device) naming the limit that a grid of this size is
  /// beyond. `bytesPerCell` of its largest buffer.
  static void checkLimits(const std::string& name, glm::ivec2 size, int bytesPerCell = 1);

  SpreadGrid(const std::string& name, const SpreadParameters& parameters,
             const std::vector<std::uint8_t>& cells, int stepsPerFrame, const Strokes& strokes);

  /// The steps of a frame: each one's rule, then the strokes that paint into what it leaves, which its
  /// counts count. `blocks` hold what each is told. `kernels` run both kernels:
  /// step(items, SpreadStepPart, block) and paint(items, SpreadPaintPart, block). A watch hears of
  /// `stepsPerFrame`, also in a frame with a step less than others.
  template <class Step, class Kernels>
  void runFrame(const std::vector<Step>& steps, StepBlocks<decltype(Step::data)>& blocks, int stepsPerFrame,
                const StepWatch& watch, const Kernels& kernels) {
    blocks.upload(steps, &Step::data);
    beginFrame(static_cast<int>(steps.size()));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const gl::Resource told = blocks.at(i);
      const SpreadStepPart given = beginStep();
      kernels.step(glm::ivec2(rowElements(), groupRows()), given, told);
      endStep();
      paint(steps[i].strokes, told, kernels);
      if (watch) watch(static_cast<int>(i) + 1);
    }
    endFrame();
    if (!watch) return;
    for (int i = static_cast<int>(steps.size()); i < stepsPerFrame; ++i) watch(i + 1);
  }
  /// Strokes that paint into the first state.
  template <class Kernels>
  void paintFirst(const std::vector<shader::Stroke>& strokes, const gl::Resource& told,
                  const Kernels& kernels) {
    paint(strokes, told, kernels);
    if (!strokes.empty()) startPainted();
  }

  void carryOver(CarryOver& carry);

  [[nodiscard]] const gl::WordsArray& cells() const { return cells_[0]; }
  [[nodiscard]] int rowElements() const { return (size_.x + 15) / 16; }
  /// Rows of the present frame; before the first step, the start as one row.
  [[nodiscard]] const gl::Buffer& frameCounts() const { return frameCounts_; }
  [[nodiscard]] int frameSteps() const { return frameSteps_; }
  /// Four counts of the present state. Waits for the GPU.
  [[nodiscard]] glm::uvec4 latestCounts() const;
  /// "cells (16, 3) to (31, 3)" of an element of the state.
  [[nodiscard]] std::string elementName(long element) const;

  void publishField(const std::string& name, const std::vector<glm::vec3>& colors,
                    const FieldDisplay& display, Drawables& drawables) const;
  /// The counts so far, the first of names.size() of them.
  void publishChart(const std::vector<std::string>& names, const std::vector<glm::vec3>& colors,
                    double steps, Drawables& drawables) const;

 private:
  /// Room for the counts of so many steps more.
  void beginFrame(int steps);
  /// Invocations of a step's kernel from the top row to the last one.
  [[nodiscard]] int groupRows() const;
  /// Arguments of the kernel of the next step.
  SpreadStepPart beginStep();
  void endStep();
  template <class Kernels>
  void paint(const std::vector<shader::Stroke>& strokes, const gl::Resource& told, const Kernels& kernels) {
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
                    told);
      fresh_ = true;
    }
  }
  /// Counts of the start, after strokes.
  void startPainted();
  /// Copies the frame's counts to where counts() says, and makes the state visible to all.
  void endFrame();

  std::string name_;
  glm::ivec2 size_;
  bool torus_;
  gl::WordsArray cells_[2];  ///< now, and where the next step writes
  gl::WordsArray history_;   ///< counts of every step, the start first; capacity_ of them
  gl::WordsArray stamps_;
  /// On the texel path what glsl/spread/tiles.glsl knows of each tile: of the last step, and where the next
  /// step writes. Nothing after a start, a restart or a stroke.
  gl::WordsArray tiles_[2];
  bool fresh_ = true;
  gl::Buffer frameCounts_;
  int capacity_ = 0;
  int done_ = 0;
  int frameStart_ = 0;
  int frameSteps_ = 1;
  unsigned max_ = 1;  ///< people or cells at the start
};

}  // namespace simreel::sim
