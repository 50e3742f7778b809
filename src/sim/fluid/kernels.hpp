#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/fluid/arrays.hpp"
#include "sim/fluid/plan.hpp"
#include "sim/fluid/pressure.hpp"
#include "sim/grid/tally.hpp"

#include <memory>
#include <string>

#include <glm/vec3.hpp>

namespace simreel::sim {

struct FluidPush;
struct FluidCarry;
struct FluidCorrect;
struct FluidFastest;
struct FluidPaint;
struct FluidPaintBack;
struct FluidShow;
struct FluidLines;
struct FluidProject;
struct FluidDyePass;
struct FluidProjectOpen;
struct FluidSettle;
struct FluidCheck;
struct FluidDyeStrips;
struct FluidSums;

/// A fluid's cells on the GPU and the kernels that step them.
class FluidKernels {
 public:
  /// Throws UserError(device) when the grid is beyond a limit of the device.
  FluidKernels(const std::string& name, const FluidPlan& plan, bool fast, double startTime = 0);

  /// What the following steps are told, those of the frame that starts at `time` (s).
  void beginFrame(double time);
  /// Obstacles as they are after `step` substeps of the frame that starts at `time` (s).
  void place(double time, int step);
  /// Substep `step` of that frame, from 1.
  void advance(double time, int step, unsigned number);
  /// The first state: what is painted at `time`, without divergence.
  void start(double time);
  /// After a state was loaded for the frame that starts at `time` (s): the obstacles, and what steps know
  /// from those before.
  void resume(double time);
  /// Makes shownWords() of the present state, that of `time` (s).
  void show(double time);

  /// Measures the present state for counts().
  void measure();
  [[nodiscard]] CountTable counts() const;

  [[nodiscard]] FluidArrays& arrays() { return arrays_; }
  [[nodiscard]] const FluidArrays& arrays() const { return arrays_; }
  /// Colour in rgb, what is shown in a, with a ring; of lines, with lineDetail places a cell and no ring.
  [[nodiscard]] const gl::Texture& shownWords() const {
    return lineWords_ ? lineWords_ : arrays_.shown().words();
  }
  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  /// The obstacles of the present state.
  [[nodiscard]] const FluidSolids& solids() const { return *solids_; }
  [[nodiscard]] FluidPressure& pressure() { return pressure_; }
  [[nodiscard]] const FluidPressure& pressure() const { return pressure_; }

 private:
  /// Kernels for tiles in the open, and for the others and the ring.
  template <class Interface>
  struct Tiled {
    gl::Kernel<Interface> open, others;
  };
  /// Over the grid and the ring around it.
  [[nodiscard]] glm::ivec2 everywhere() const { return plan_.size() + 2; }
  [[nodiscard]] FluidPart part() const { return pressure_.part(steps_.at(step_)); }
  template <class Interface>
  void runOthers(const gl::Kernel<Interface>& kernel, Interface given) const;
  template <class Interface>
  void runOpen(const gl::Kernel<Interface>& kernel, Interface given) const;
  /// `all`: the ring around the grid, too, wherever brushes are.
  void paint(double time, int step, bool all);
  void project(unsigned number);
  [[nodiscard]] FluidProject projection(unsigned number) const;
  /// Of storage blocks: in place, and what is told of it by a kernel that finds ways for dye, too.
  void projectInPlace(unsigned number);
  void moveDye();
  /// One pass or two, from where dye is to where it is free.
  void moveDye(int passes) const;
  void makeShowing(const std::string& name, const gl::Defines& defines);

  const FluidPlan& plan_;
  std::shared_ptr<const FluidSolids> solids_;
  gl::Vec4Array lines_;  ///< where lines are shown
  gl::Texture lineWords_;
  gl::WordsArray stamps_;
  gl::Vec4Array stops_;
  gl::Buffer status_, brushes_;
  gl::Buffer kept_;  ///< glsl/fluid/kept.glsl
  StepBlocks<shader::FluidStep> steps_;
  std::size_t step_ = 0;  ///< of steps_, the one that kernels are told
  gl::Kernel<FluidPush> push_;
  gl::Kernel<FluidCarry> carry_;
  gl::Kernel<FluidCorrect> correct_;
  gl::Kernel<FluidFastest> fastest_;
  gl::Kernel<FluidPaint> paint_;
  gl::Kernel<FluidPaintBack> paintBack_;
  gl::Kernel<FluidShow> show_;
  gl::Kernel<FluidLines> showLines_;
  Tiled<FluidProject> project_;  ///< of storage blocks only others
  Tiled<FluidDyePass> moveDye_;
  // Of storage blocks; one pass of dye, and two at once.
  gl::Kernel<FluidProjectOpen> projectOpen_;
  gl::Kernel<FluidSettle> settle_;
  gl::Kernel<FluidCheck> check_;
  gl::Kernel<FluidDyeStrips> dyeStrips_[2];
  FluidPressure pressure_;
  FluidArrays arrays_;
  Tally tally_;
  gl::Kernel<FluidSums> sums_;
  glm::vec4 perCells_{1};  ///< of the sums: means over open cells, and over corners in the open
};

}  // namespace simreel::sim
