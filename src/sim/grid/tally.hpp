#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/simulation.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

struct TallyJoin;

/// Computes four sums and four maxima over the cells of a field once per frame, on the GPU and in an order
/// that is the same on every machine. Used for the table written next to the frame images.
class Tally {
 public:
  static const int lanes;

  Tally() = default;
  Tally(const std::string& name, const gl::Defines& defines);

  /// Returns the array into which kernels that include glsl/grid/tally.glsl write the sums of their `lanes`
  /// invocations.
  [[nodiscard]] const gl::Vec4Array& laneSums() const { return laneSums_; }
  /// Combines laneSums() into the totals. Call it after a kernel has written them. The resulting sums are
  /// multiplied by `sumFactor`, the maxima by `maxFactor`.
  void join(const glm::vec4& sumFactor, const glm::vec4& maxFactor) const;
  /// Returns the table of the sums followed by the maxima, with these column names (at most eight).
  [[nodiscard]] CountTable table(std::vector<const char*> columns) const;

 private:
  gl::Vec4Array laneSums_, joined_, total_;
  gl::Kernel<TallyJoin> join_;
};

}  // namespace simreel::sim
