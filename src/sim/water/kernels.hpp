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
struct WaterShow;
struct WaterSums;

/// The water's cells on the GPU and what is dispatched over them.
class WaterKernels {
 public:
  /// Throws UserError(device) where a grid of `size` cells is beyond the device's limits; before anything
  /// is filled, for a grid far beyond them would first take gigabytes.
  static void checkLimits(const std::string& name, glm::ivec2 size);

  /// `plan` outlives this.
  WaterKernels(const std::string& name, const WaterPlan& plan, bool fast);

  /// What the steps of the frame that starts at `time` (s) are told.
  void startFrame(double time);
  /// Step `number` of the frame, from 1.
  void step(int number);
  /// Rain, drops and strokes into the state after step `number`.
  void fall(double time, int number) const;
  /// Makes what is drawn and shown.
  void look() const;
  /// What is measured of the present state, for the table beside the frames.
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
  /// By strips (step_strips.comp), or by columns, one an invocation.
  bool strips_ = gl::memoryPath() == gl::MemoryPath::storage;
  /// Rows of a strip or column: the more, the less is computed twice; fewer where there is little to share
  /// out.
  int rowsEach_;
  gl::Vec4Array cells_[2];  ///< now, and where the next step writes: until then what is drawn and shown
  gl::Texture words_[2];    ///< of both
  gl::WordsArray stamps_;
  gl::Buffer status_;
  StepBlocks<shader::WaterStep> steps_;
  gl::Buffer look_;
  gl::Kernel<WaterColumns> columns_;
  gl::Kernel<WaterStrips> stripSteps_;
  gl::Kernel<WaterPaint> paint_, drop_;
  gl::Kernel<WaterShow> show_;
  gl::Kernel<WaterSums> sums_;
  Tally tally_;
};

}  // namespace simreel::sim
