#pragma once
#include "sim/contact/plan.hpp"

#include <utility>
#include <vector>

#include <glm/vec4.hpp>

/// Contact on the CPU: the kernels' own model (glsl/contact/model.glsl compiled as C++) in plain loops, and
/// every face with every other instead of the tree.
class ContactTwin {
 public:
  explicit ContactTwin(simreel::sim::ContactPlan plan) : plan_(std::move(plan)) {}

  struct Part {
    const std::vector<glm::vec4>* now;   ///< at the substep's start: xyz m, w inverse mass, of balls mass
    std::vector<glm::vec4>* next;        ///< where it would lead; becomes where it leads
    std::vector<glm::vec4>* velocities;  ///< xyz m/s; null of a solid
  };
  /// Changes `next` by the contacts' impulses. `first`: of a frame.
  void push(const std::vector<Part>& parts, bool first);
  /// After push(), where colliders may have moved `next` again.
  void hold(const std::vector<Part>& parts);

  /// Of the last substep.
  std::size_t pairs = 0, nears = 0, touching = 0, stopped = 0, carried = 0;
  long searches = 0;  ///< so far
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
