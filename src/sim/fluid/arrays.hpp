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

/// The memory of a fluid's state and of what its steps are at. Of texels four arrays of four floats a cell,
/// of which any can be any. On the storage path a float of neighbouring cells lies together, and each array
/// has what it holds and no more: the flow u, v, temperature and pressure; the dye its three colours; what
/// carries it along another three; the solver, which wants most, a few bytes more than three. These three
/// share a buffer, dye at one end of it or the other, so that what is free is in one piece.
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
  /// Free between the stages of a step: three floats a cell at least, and all that the solver's `pool` has.
  [[nodiscard]] const FluidArray& scratch() const { return arrays_[scratch_]; }
  /// Free, too: three floats a cell, and the solver's `raised`.
  [[nodiscard]] const FluidArray& spare() const { return arrays_[spare_]; }
  /// What is shown, four floats a cell, in what is free.
  [[nodiscard]] const FluidArray& shown() const;

  /// Whether all arrays are alike, so that flow and dye may be in any.
  [[nodiscard]] bool alike() const { return texels_; }
  void turnFlow(bool withScratch);  ///< where they are: flow and scratch change places, or flow and spare
  void turnDye() { std::swap(dye_, spare_); }
  /// Of the scratch, floats: from where on there is a plane of a float a cell besides the solver's sums.
  [[nodiscard]] int planeBesideSums() const { return planeBesideSums_; }

  [[nodiscard]] StateArray flowState() const { return stateOf(flow_, "flow", 4); }
  [[nodiscard]] StateArray dyeState() const { return stateOf(dye_, "dye", 3); }
  /// For Field: words from cell to cell, and from one of its floats to the next.
  [[nodiscard]] int cellWords() const { return texels_ ? 4 : 1; }
  [[nodiscard]] int floatWords() const { return texels_ ? 1 : elements_; }
  /// Flow and dye, element by element on every path.
  void carryOver(CarryOver& carry);

 private:
  [[nodiscard]] StateArray stateOf(int array, const char* name, int planes) const;
  void carryOver(CarryOver& carry, int array, const char* name, int planes);

  bool texels_;
  int elements_, planeBesideSums_ = 0;
  gl::Buffer buffers_[4];
  FluidArray arrays_[4], free_[2];  ///< free: before the dye, after it
  int flow_ = 0, dye_ = 1, scratch_ = 2, spare_ = 3;
  gl::Kernel<FluidGather> gather_, scatter_;  ///< made when they are wanted
};

}  // namespace simreel::sim
