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

/// The cells of a Gray-Scott field on the GPU and the kernels that step them.
class GrayScottKernels {
 public:
  /// How the work is cut up; every choice gives the same bits.
  struct Cut {
    int across = 1;  ///< elements (two cells) that an invocation of a single step takes in a row
    int rows = 1;    ///< and rows
    int groupX = 32, groupY = 4;
    int bandRows = -1;  ///< rows that single steps stay in (bands()); 0: all; -1: as the grid's size asks
    int stepsPerPass = 1;   ///< 2, 3, 4, 6 or 8: several steps a pass, in strips
    int stripElements = 1;  ///< elements across a strip that each of its invocations takes
    int stripRows = 64;     ///< and rows that they go down
  };
  /// What is fastest for a grid of that size on this device's memory path.
  [[nodiscard]] static Cut bestCut(glm::ivec2 size);

  /// Throws UserError(device) when the grid is beyond a limit of the device.
  GrayScottKernels(const std::string& name, const GrayScottPlan& plan, bool fast, const Cut& cut);
  GrayScottKernels(const std::string& name, const GrayScottPlan& plan, bool fast)
      : GrayScottKernels(name, plan, fast, bestCut(plan.parameters().size)) {}

  /// What the following steps use.
  void setRates(const shader::GrayScottRates& rates);
  /// Advances by `steps`, several in a pass where the cut says so.
  void advance(int steps);
  void paint(const shader::Stroke& stroke);

  /// As Simulation::status(): a remark where a step held a cell to [0, 1]. Looked at after 1, 2, 4, ... 128
  /// steps (as far as a pass ends there), after every 128 from then on, and in this order again after
  /// strokes.
  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_[0]; }
  [[nodiscard]] gl::Vec4Array& cells() { return cells_[0]; }
  /// The same as words, for Field.
  [[nodiscard]] const gl::Texture& words() const { return words_[0]; }

 private:
  /// Arguments of all kernels but painting, which read cells_[from].
  [[nodiscard]] GrayScottGrid grid(int from, int first, int rows) const;
  void bands(int steps);
  void swapCells();
  /// After `steps` more.
  void look(int steps);
  /// One step from cells_[from] to the other array, `rows` of them from `first` on, over the border where
  /// need be.
  void pass(int from, int first, int rows);
  /// cut_.stepsPerPass steps of all.
  void stripPass();

  glm::ivec2 size_;
  int columns_;
  Cut cut_;
  gl::Vec4Array cells_[2];  ///< now, and where the next pass writes
  gl::Texture words_[2];
  gl::Vec4Array weights_;
  gl::WordsArray stamps_;
  gl::Buffer status_, rates_;
  gl::Kernel<GrayScottStep> step_;
  gl::Kernel<GrayScottStrips> strips_;
  gl::Kernel<GrayScottLook> look_;
  gl::Kernel<GrayScottPaint> paint_;
  long taken_ = 0;     ///< steps since the start or the latest stroke
  long nextLook_ = 1;  ///< of those
  bool mapped_;
};

}  // namespace simreel::sim
