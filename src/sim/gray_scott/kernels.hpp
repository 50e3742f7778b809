#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/gray_scott/plan.hpp"

#include <string>

namespace simreel::sim {

struct GrayScottGrid;
struct GrayScottStep;
struct GrayScottStrips;
struct GrayScottLook;
struct GrayScottPaint;

/// Owns the cells of a Gray-Scott field on the GPU and the kernels that step them.
class GrayScottKernels {
 public:
  /// Distribution of the work among invocations. Every choice gives the same bits.
  struct Cut {
    int across =
        1;         ///< Number of consecutive elements (of two cells each) per invocation of a single step.
    int rows = 1;  ///< Number of rows per invocation of a single step.
    int groupX = 32, groupY = 4;
    int bandRows = -1;      ///< Number of rows per band for single steps (bands()); 0 for no bands, -1 to
                            ///< choose it by the grid size.
    int stepsPerPass = 1;   ///< Number of steps per pass of strips: 2, 3, 4, 6 or 8; 1 for no strips.
    int stripElements = 1;  ///< Number of elements across a strip per invocation.
    int stripRows = 64;     ///< Number of rows per strip.
  };
  /// Returns the fastest distribution for this grid size and this device's memory path.
  [[nodiscard]] static Cut bestCut(glm::ivec2 size);

  /// Throws UserError(device) if the grid exceeds a limit of the device.
  GrayScottKernels(const std::string& name, const GrayScottPlan& plan, bool fast, const Cut& cut);
  GrayScottKernels(const std::string& name, const GrayScottPlan& plan, bool fast)
      : GrayScottKernels(name, plan, fast, bestCut(plan.parameters().size)) {}

  /// Sets the rates for the following steps.
  void setRates(const shader::GrayScottRates& rates);
  /// Advances by `steps` steps, with several steps per pass if the distribution allows.
  void advance(int steps);
  void paint(const shader::Stroke& stroke);

  /// Returns the status buffer of Simulation::status(). It triggers a remark if a step clamped a cell to
  /// [0, 1]. The buffer is updated after 1, 2, 4, ... 128 steps (at the end of a pass), then after every
  /// 128 steps. A stroke restarts this sequence.
  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_[0]; }
  [[nodiscard]] gl::Vec4Array& cells() { return cells_[0]; }
  /// Returns the cells as a view of 32-bit words, for Field.
  [[nodiscard]] const gl::Texture& words() const { return words_[0]; }

 private:
  /// Returns the interface part for all kernels except the painting kernel; the kernels read cells_[from].
  [[nodiscard]] GrayScottGrid grid(int from, int first, int rows) const;
  void bands(int steps);
  void swapCells();
  /// Counts `steps` more steps and, if a check is due, checks the cells for a remark.
  void look(int steps);
  /// Computes one step for `rows` rows, starting with row `first` and wrapping at the border. Reads
  /// cells_[from] and writes the other array.
  void pass(int from, int first, int rows);
  /// Runs cut_.stepsPerPass steps of the whole grid.
  void stripPass();

  glm::ivec2 size_;
  int columns_;
  Cut cut_;
  gl::Vec4Array cells_[2];  ///< Current state, and the output of the next pass.
  gl::Texture words_[2];
  gl::Vec4Array weights_;
  gl::WordsArray stamps_;
  gl::Buffer status_, rates_;
  gl::Kernel<GrayScottStep> step_;
  gl::Kernel<GrayScottStrips> strips_;
  gl::Kernel<GrayScottLook> look_;
  gl::Kernel<GrayScottPaint> paint_;
  long taken_ = 0;     ///< Number of steps since the start or since the latest stroke.
  long nextLook_ = 1;  ///< Value of `taken_` at which the next check is due.
  bool mapped_;
};

}  // namespace simreel::sim
