#pragma once
#include "draw/exact/exact_view.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// The shader files of reflections as C++, for perspective cameras (rays from the eye).
struct ReflectionsTwin {
  simreel::shader::ExactView view;
  glm::vec2 reach{0};  ///< result of draw::Reflections::reachOf()

  /// Sets the nearness of half-resolution pixels (1/m) and the light of pixels, row by row.
  void see(const std::vector<float>& nearness, const std::vector<glm::vec4>& light);
  /// A ray from `p` in a unit direction, from a surface with normal `facing`; `towards` points to the eye.
  struct Ray {
    glm::vec3 p{0}, direction{0}, facing{0}, towards{0};
    float roughness = 0, turns = 0;
    float ground = -1;  ///< distance along the ray to the ground (m; -1: never)
  };
  /// Returns the reflected light in rgb, and its weight in a.
  [[nodiscard]] glm::vec4 lightMet(const Ray& ray) const;

  [[nodiscard]] glm::ivec2 half() const { return (view.size + 1) / 2; }
  std::vector<float> nearest;  ///< nearest surface in each texel, by mip level
  std::vector<glm::vec4> lit;
};
