#pragma once
#include "sim/contact/plan.hpp"

#include <utility>
#include <vector>

#include <glm/vec4.hpp>

/// Contact on the CPU: the kernels' model (glsl/contact/model.glsl compiled as C++) in plain loops, with
/// tests of every pair of faces instead of a tree.
class ContactTwin {
 public:
  explicit ContactTwin(simreel::sim::ContactPlan plan) : plan_(std::move(plan)) {}

  struct Part {
    /// positions at the start of the substep (xyz, m); w is the inverse mass, for spheres the mass
    const std::vector<glm::vec4>* now;
    std::vector<glm::vec4>* next;        ///< predicted positions; contact corrects them
    std::vector<glm::vec4>* velocities;  ///< velocities (xyz, m/s); null for a solid
  };
  /// Changes `next` by the impulses of the contacts. `first`: true in the first substep of a frame.
  void push(const std::vector<Part>& parts, bool first);
  /// Corrects `next` after push() if colliders may have moved it again.
  void hold(const std::vector<Part>& parts);

  /// Counts of the last substep.
  std::size_t pairs = 0, nears = 0, touching = 0, stopped = 0, carried = 0;
  long searches = 0;  ///< total number of pair searches so far
  bool allStopped = false;

 private:
  [[nodiscard]] float thicknessOf(auto& kernel, const glm::ivec4& corners) const;

  simreel::sim::ContactPlan plan_;
  std::vector<simreel::shader::Hull> hulls_;
  std::vector<glm::ivec4> vertexPairs_, edgePairs_;
  std::vector<glm::vec4> now_, next_, wanted_;
  std::vector<glm::vec3> starts_;
  std::vector<float> beside_, roam_;
  float stir_ = 0, searched_ = 0;
  std::vector<simreel::shader::Near> near_;
};
