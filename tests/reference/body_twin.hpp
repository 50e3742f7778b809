#pragma once
#include "sim/body/motion.hpp"
#include "sim/core/shader_code.hpp"

#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of skinning. It runs the kernel's own model (glsl/body/model.glsl compiled as C++).
class BodyTwin {
 public:
  explicit BodyTwin(const simreel::sim::Figure& figure) : figure_(figure) {}

  /// Skins all vertices for a moment between two poses (BodyMotion::rowsAt). `now`: the moment, as a
  /// fraction of the frame.
  void skin(std::vector<glm::vec4> begin, const std::vector<glm::vec4>& end, double now) {
    begin.insert(begin.end(), end.begin(), end.end());
    positions.clear();
    normals.clear();
    Model model{begin};
    const Model::Moment moment{static_cast<int>(figure_.joints.size()), static_cast<float>(1.0 - now),
                               static_cast<float>(now)};
    for (std::size_t i = 0; i < figure_.follow.size(); ++i) {
      const Model::Blend blend = model.blendOf(figure_.follow[i], figure_.weights[i], moment);
      positions.emplace_back(model.skinnedPosition(blend, figure_.mesh.positions[i]), 1.0F);
      normals.emplace_back(model.skinnedNormal(blend, figure_.mesh.normals[i]), 0.0F);
    }
  }

  std::vector<glm::vec4> positions, normals;

 private:
#define FUNCTION inline
#define precise
  struct Model {
    const std::vector<glm::vec4>& poses;
    using vec3 = glm::vec3;
    using vec4 = glm::vec4;
    using uvec4 = glm::uvec4;
    static float exactFlush(float x) { return simreel::shader::exactFlush(x); }
    static float exactDot(vec3 a, vec3 b) { return simreel::shader::exactDot(a, b); }
    static vec3 exactCross(vec3 a, vec3 b) { return simreel::shader::exactCross(a, b); }
    static float exactInverseSqrt(float x) { return simreel::shader::exactInverseSqrt(x); }
    static float max(float a, float b) { return glm::max(a, b); }
    [[nodiscard]] vec4 loadPose(int i) const { return poses[static_cast<std::size_t>(i)]; }
#include "glsl/body/model.glsl"
  };
#undef precise
#undef FUNCTION

  const simreel::sim::Figure& figure_;
};
