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
struct FluidDisplay;
struct FluidLines;
struct FluidProject;
struct FluidDyePass;
struct FluidProjectOpen;
struct FluidSettle;
struct FluidCheck;
struct FluidDyeStrips;
struct FluidSums;

/// Owns a fluid's cells on the GPU and the kernels that step them.
class FluidKernels {
 public:
  /// Throws UserError(device) if the grid exceeds a limit of the device.
  FluidKernels(const std::string& name, const FluidPlan& plan, bool fast, double startTime = 0);

  /// Uploads the parameters of all substeps of the frame that starts at `time` (seconds).
  void beginFrame(double time);
  /// Places the obstacles at their positions after `step` substeps of the frame that starts at `time`
  /// (seconds).
  void place(double time, int step);
  /// Runs substep `step` (counted from 1) of the frame that starts at `time`.
  void advance(double time, int step, unsigned number);
  /// Computes the initial state at `time`: paints the strokes, then projects the flow to zero divergence.
  void start(double time);
  /// Restores the obstacles, and the control values that a step takes from earlier steps. Call it after
  /// loading a state for the frame that starts at `time` (seconds).
  void resume(double time);
  /// Computes shownWords() from the current state at `time` (seconds).
  void prepareDrawing(double time);

  /// Measures the current state for counts().
  void measure();
  [[nodiscard]] CountTable counts() const;

  [[nodiscard]] FluidArrays& arrays() { return arrays_; }
  [[nodiscard]] const FluidArrays& arrays() const { return arrays_; }
  /// Returns the displayed values: colour in rgb, shown quantity in a, including a ring of cells. For flow
  /// lines: lineDetail x lineDetail elements per cell and no ring.
  [[nodiscard]] const gl::Texture& shownWords() const {
    return lineWords_ ? lineWords_ : arrays_.shown().words();
  }
  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  /// Returns the obstacles of the current state.
  [[nodiscard]] const FluidSolids& solids() const { return *solids_; }
  [[nodiscard]] FluidPressure& pressure() { return pressure_; }
  [[nodiscard]] const FluidPressure& pressure() const { return pressure_; }

 private:
  /// Two variants of a kernel: for open tiles, and for the other tiles and the ring.
  template <class Interface>
  struct Tiled {
    gl::Kernel<Interface> open, others;
  };
  /// Returns the dispatch size that covers the grid and the ring around it.
  [[nodiscard]] glm::ivec2 everywhere() const { return plan_.size() + 2; }
  [[nodiscard]] FluidPart part() const { return pressure_.part(steps_.at(step_)); }
  template <class Interface>
  void runOthers(const gl::Kernel<Interface>& kernel, Interface given) const;
  template <class Interface>
  void runOpen(const gl::Kernel<Interface>& kernel, Interface given) const;
  /// Paints the brushes' boxes, or all cells and the whole ring if `all` is true.
  void paint(double time, int step, bool all);
  void project(unsigned number);
  [[nodiscard]] FluidProject projection(unsigned number) const;
  /// Projects the flow in place on the storage path, then runs check_, which measures the result and
  /// computes the distances by which dye is advected.
  void projectInPlace(unsigned number);
  void moveDye();
  /// Advects dye into the spare array, by one pass or by two passes in one dispatch.
  void moveDye(int passes) const;
  void makeShowing(const std::string& name, const gl::Defines& defines);

  const FluidPlan& plan_;
  std::shared_ptr<const FluidSolids> solids_;
  gl::Vec4Array lines_;  ///< Output buffer of the flow line display; empty if flow lines are not displayed.
  gl::Texture lineWords_;
  gl::WordsArray stamps_;
  gl::Vec4Array stops_;
  gl::Buffer status_, brushes_;
  gl::Buffer kept_;  ///< Buffer for the fraction of the pressure that remains between steps
                     ///< (glsl/fluid/kept.glsl).
  StepBlocks<shader::FluidStep> steps_;
  std::size_t step_ = 0;  ///< Index in `steps_` of the uniform block that is passed to kernels.
  gl::Kernel<FluidPush> push_;
  gl::Kernel<FluidCarry> carry_;
  gl::Kernel<FluidCorrect> correct_;
  gl::Kernel<FluidFastest> fastest_;
  gl::Kernel<FluidPaint> paint_;
  gl::Kernel<FluidPaintBack> paintBack_;
  gl::Kernel<FluidDisplay> display_;
  gl::Kernel<FluidLines> displayLines_;
  Tiled<FluidProject> project_;  ///< Projection kernels; on the storage path only `others` is created.
  Tiled<FluidDyePass> moveDye_;
  // Kernels for the storage path. dyeStrips_[0] computes one pass of dye advection, dyeStrips_[1] two
  // passes in one dispatch.
  gl::Kernel<FluidProjectOpen> projectOpen_;
  gl::Kernel<FluidSettle> settle_;
  gl::Kernel<FluidCheck> check_;
  gl::Kernel<FluidDyeStrips> dyeStrips_[2];
  FluidPressure pressure_;
  FluidArrays arrays_;
  Tally tally_;
  gl::Kernel<FluidSums> sums_;
  glm::vec4 perCells_{1};  ///< Factors that turn sums into means over open cells and over corners between
                           ///< open cells.
};

}  // namespace simreel::sim
