#pragma once
#include "sim/contact/plan.hpp"

#include <utility>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of contact. It runs the kernels' own model (glsl/contact/model.glsl compiled as C++) in plain
/// loops. Tests every pair of faces instead of searching a tree.
class ContactTwin {
 public:
  explicit ContactTwin(simreel::sim::ContactPlan plan) : plan_(std::move(plan)) {}

  struct Part {
    const std::vector<glm::vec4>* now;   ///< positions at the substep's start: xyz in metres; w: inverse
                                         ///< mass (balls: mass)
    std::vector<glm::vec4>* next;        ///< proposed positions at the substep's end, which push() corrects
    std::vector<glm::vec4>* velocities;  ///< velocities in m/s; null for a solid
  };
  /// Changes `next` by the impulses of the contacts. `first`: true in the first substep of a frame.
  void push(const std::vector<Part>& parts, bool first);
  /// Resolves the contacts again after push(), because colliders may have moved `next`.
  void hold(const std::vector<Part>& parts);

  /// Counts of the last substep: candidate pairs, near pairs, touching pairs, vertices whose motion was
  /// shortened, and vertices that moving solids carried along.
  std::size_t pairs = 0, nears = 0, touching = 0, stopped = 0, carried = 0;
  long searches = 0;  ///< total number of searches so far
  bool allStopped = false;

 private:
  [[nodiscard]] float thicknessOf(auto& kernel, const glm::ivec4& corners) const;

  simreel::sim::ContactPlan plan_;
  std::vector<simreel::shader::Hull> hulls_;
  std::vector<glm::ivec4> vertexPairs_, edgePairs_;
  std::vector<glm::vec4> now_, next_, wanted_;
  std::vector<glm::vec3> starts_;
  std::vector<float> beside_, extraMoves_;
  float maxPath_ = 0, searched_ = 0;
  std::vector<simreel::shader::Near> near_;
};
