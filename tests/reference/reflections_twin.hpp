#pragma once
#include "draw/exact/exact_view.hpp"

#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// CPU twin of reflections. It runs the shader files as C++, for perspective cameras.
struct ReflectionsTwin {
  simreel::shader::ExactView view;
  glm::vec2 reach{0};  ///< result of draw::Reflections::reachOf()

  /// Stores the nearness (1/m) of half-resolution pixels and the light of full-size pixels, row by row, and
  /// builds the mip levels of both.
  void see(const std::vector<float>& nearness, const std::vector<glm::vec4>& light);
  /// Stores the nearness (1/m) of full-size pixels, row by row. Rays are then traced as for uneven half
  /// pixels.
  void refine(std::vector<float> nearness) { nearestOfPixels = std::move(nearness); }
  /// A reflection ray from `p` in a unit direction. `facing`: normal of the surface. `towards`: unit
  /// direction to the eye.
  struct Ray {
    glm::vec3 p{0}, direction{0}, facing{0}, towards{0};
    float roughness = 0, turns = 0;
    float ground = -1;  ///< distance along the ray to the ground in metres; -1 if the ray does not hit it
  };
  /// Returns the reflected light (rgb) and the light's weight (a).
  [[nodiscard]] glm::vec4 lightMet(const Ray& ray) const;

  [[nodiscard]] glm::ivec2 half() const { return (view.size + 1) / 2; }
  std::vector<float> nearest;  ///< nearness, all mip levels
  std::vector<glm::vec4> lit;
  std::vector<float> nearestOfPixels;  ///< empty if rays are traced for half-resolution pixels
  std::vector<glm::vec4> lightOfPixels;
};
