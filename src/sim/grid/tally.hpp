#pragma once
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "sim/core/simulation.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Four sums over the cells of a field and four greatest values, once a frame, on the GPU in an order that
/// is the same on every machine: for the table beside the frames.
class Tally {
 public:
  Tally() = default;
  /// `path`: a kernel that includes glsl/grid/tally.glsl.
  Tally(const std::string& name, const char* path, const gl::Defines& defines);

  /// For what it reads.
  [[nodiscard]] const gl::Program& kernel() const { return lanes_; }
  /// Once that is bound. `sumFactor`, `mostFactor`: of the results.
  void take(const glm::vec4& sumFactor, const glm::vec4& mostFactor);
  /// The sums, then the greatest values, under these names: at most eight.
  [[nodiscard]] CountTable table(std::vector<const char*> columns) const;

 private:
  void join(const gl::Vec4Array& from, const gl::Vec4Array& to, int lanes, const glm::vec4& sumFactor,
            const glm::vec4& mostFactor) const;

  gl::Vec4Array laneSums_, joined_, total_;
  gl::Program lanes_, join_;
};

}  // namespace simreel::sim
