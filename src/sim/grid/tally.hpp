#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/simulation.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

struct TallyJoin;

/// Four sums over the cells of a field and four greatest values, once a frame, on the GPU in an order that
/// is the same on every machine: for the table beside the frames.
class Tally {
 public:
  static const int lanes;

  Tally() = default;
  Tally(const std::string& name, const gl::Defines& defines);

  /// Where a kernel that includes glsl/grid/tally.glsl leaves the sums of its `lanes` invocations.
  [[nodiscard]] const gl::Vec4Array& laneSums() const { return laneSums_; }
  /// Once it has. `sumFactor`, `mostFactor`: of the results.
  void join(const glm::vec4& sumFactor, const glm::vec4& mostFactor) const;
  /// The sums, then the greatest values, under these names: at most eight.
  [[nodiscard]] CountTable table(std::vector<const char*> columns) const;

 private:
  gl::Vec4Array laneSums_, joined_, total_;
  gl::Kernel<TallyJoin> join_;
};

}  // namespace simreel::sim
