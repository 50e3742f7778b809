#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/state_array.hpp"
#include "sim/fluid/array.hpp"
#include "sim/fluid/plan.hpp"

#include <span>
#include <string>
#include <utility>

#include <glm/vec4.hpp>

namespace simreel::sim {

struct FluidGather;

/// GPU memory of a fluid's state and of the working arrays of its steps. On the texel path there are four
/// interchangeable arrays of four floats per cell. On the storage path, the state is stored in planes
/// (structure of arrays), and each array has only the planes it needs: flow has four (u, v, temperature,
/// pressure), dye three (its colours), the spare array for dye advection three, and the scratch array of
/// the pressure solver slightly more than three. Dye, scratch and spare are parts of one buffer with
/// scratch in the middle. Dye and spare can swap the two ends, so the free memory is always contiguous.
class FluidArrays {
 public:
  FluidArrays(const std::string& name, const FluidPlan& plan, std::span<const glm::vec4> flow);
  ~FluidArrays() = default;
  FluidArrays(FluidArrays&&) = delete;
  FluidArrays& operator=(FluidArrays&&) = delete;
  FluidArrays(const FluidArrays&) = delete;
  FluidArrays& operator=(const FluidArrays&) = delete;

  [[nodiscard]] const FluidArray& flow() const { return arrays_[flow_]; }
  [[nodiscard]] const FluidArray& dye() const { return arrays_[dye_]; }
  /// Returns the array that is free between the stages of a step. It has at least three floats per cell and
  /// is large enough for the pressure solver's `pool`.
  [[nodiscard]] const FluidArray& scratch() const { return arrays_[scratch_]; }
  /// Returns the second free array. It has three floats per cell and is large enough for the solver's
  /// `raised`.
  [[nodiscard]] const FluidArray& spare() const { return arrays_[spare_]; }
  /// Returns the array for the displayed values: four floats per cell, in memory that is free while
  /// drawing.
  [[nodiscard]] const FluidArray& shown() const;

  /// Returns true if all arrays have the same layout and size, so that flow and dye can be in any of them.
  [[nodiscard]] bool alike() const { return texels_; }
  void swapFlow(bool withScratch);  ///< Swaps flow with scratch if `withScratch` is true, otherwise with
                                    ///< spare.
  void turnDye() { std::swap(dye_, spare_); }
  /// Returns the offset in floats, from the start of scratch, of a plane with one float per cell. The plane
  /// does not overlap the solver's sums.
  [[nodiscard]] int planeBesideSums() const { return planeBesideSums_; }

  [[nodiscard]] StateArray flowState() const { return stateOf(flow_, "flow", 4); }
  [[nodiscard]] StateArray dyeState() const { return stateOf(dye_, "dye", 3); }
  /// Strides for Field in words: from one cell to the next, and from one float of a cell to the next.
  [[nodiscard]] int cellWords() const { return texels_ ? 4 : 1; }
  [[nodiscard]] int floatWords() const { return texels_ ? 1 : elements_; }
  /// Visits flow and dye. On every memory path, checkpoint files hold four consecutive floats per cell,
  /// which is the layout of the texel path.
  void visitCheckpointData(CarryOver& carry);

 private:
  [[nodiscard]] StateArray stateOf(int array, const char* name, int planes) const;
  void visitCheckpointData(CarryOver& carry, int array, const char* name, int planes);

  bool texels_;
  int elements_, planeBesideSums_ = 0;
  gl::Buffer buffers_[4];
  FluidArray arrays_[4],
      free_[2];  ///< Free parts of the buffer that shown() can use: [0] before the dye, [1] after the dye.
  int flow_ = 0, dye_ = 1, scratch_ = 2, spare_ = 3;
  gl::Kernel<FluidGather> gather_,
      scatter_;  ///< Kernels that convert between planes and consecutive elements; created on first use.
};

}  // namespace simreel::sim
