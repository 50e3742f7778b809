#pragma once
#include "draw/exact/exact_view.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// The shader files of reflections as C++, of cameras that see along rays from the eye.
struct ReflectionsTwin {
  simreel::shader::ExactView view;
  glm::vec2 reach{0};  ///< draw::Reflections::reachOf()

  /// Takes over nearness of half pixels (1/m) and light of pixels, row by row.
  void see(const std::vector<float>& nearness, const std::vector<glm::vec4>& light);
  /// A ray from `p` in a unit direction, of a surface that faces `facing`; the eye is `towards`.
  struct Ray {
    glm::vec3 p{0}, direction{0}, facing{0}, towards{0};
    float roughness = 0, turns = 0;
    float ground = -1;  ///< how far it goes until it meets that (m; -1: never)
  };
  /// Light that it brings, and how much of it that is.
  [[nodiscard]] glm::vec4 lightMet(const Ray& ray) const;

  [[nodiscard]] glm::ivec2 half() const { return (view.size + 1) / 2; }
  std::vector<float> nearest;  ///< in levels
  std::vector<glm::vec4> lit;
};
