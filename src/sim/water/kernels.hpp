#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/grid/tally.hpp"
#include "sim/water/plan.hpp"

#include <string>

namespace simreel::sim {

struct WaterStepPart;
struct WaterColumns;
struct WaterStrips;
struct WaterPaint;
struct WaterDisplay;
struct WaterSums;
struct WaterBed;
class HeightField;

/// Owns the water's cells on the GPU and the kernels that process them.
class WaterKernels {
 public:
  /// Throws UserError(device) if a grid of `size` cells exceeds the device's limits. Call it before filling
  /// arrays, because the arrays of an oversized grid would take gigabytes.
  static void checkLimits(const std::string& name, glm::ivec2 size);

  /// `plan` must outlive this object.
  WaterKernels(const std::string& name, const WaterPlan& plan, bool fast);

  /// Uploads the parameters of the steps of the frame that starts at `time` (seconds).
  void startFrame(double time);
  /// Runs step `number` (counted from 1) of the frame.
  void step(int number);
  /// Moves the bed to the heights of another object at the end of step `number` of the frame. 0 stands for
  /// the start of the run, where the level stays the same.
  void follow(const HeightField& heights, int number) const;
  /// Applies rain, drops, drains and strokes to the state after step `number` of the frame that starts at
  /// `time`.
  void fall(double time, int number) const;
  /// Computes the displayed values and the drawn vertices.
  void look() const;
  /// Measures the current state for the table written next to the frame images.
  void tally(double time);

  [[nodiscard]] gl::Vec4Array& cells() { return cells_[0]; }
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_[0]; }
  [[nodiscard]] const gl::Vec4Array& shown() const { return cells_[1]; }
  [[nodiscard]] const gl::Texture& cellWords() const { return words_[0]; }
  [[nodiscard]] const gl::Texture& shownWords() const { return words_[1]; }
  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  [[nodiscard]] const Tally& tally() const { return tally_; }

 private:
  const WaterPlan* plan_;
  glm::ivec2 size_;
  /// True if strips are processed (step_strips.comp), false if columns are, one per invocation (step.comp).
  bool strips_ = gl::memoryPath() == gl::MemoryPath::storage;
  /// Number of rows per strip or column. With more rows, fewer rows are computed twice; a small grid uses
  /// fewer rows, so that there are enough workgroups.
  int rowsEach_;
  gl::Vec4Array cells_[2];  ///< Current state, and the output of the next step. Between steps the second
                            ///< array holds the displayed values.
  gl::Texture words_[2];    ///< Views of both arrays as 32-bit words.
  gl::WordsArray stamps_;
  gl::Buffer status_;
  StepBlocks<shader::WaterStep> steps_;
  gl::Buffer look_;
  gl::Kernel<WaterColumns> columns_;
  gl::Kernel<WaterStrips> stripSteps_;
  gl::Kernel<WaterPaint> paint_, drop_;
  gl::Kernel<WaterDisplay> display_;
  gl::Kernel<WaterSums> sums_;
  gl::Kernel<WaterBed> bed_;
  Tally tally_;
};

}  // namespace simreel::sim
