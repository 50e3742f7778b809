#pragma once
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// What rays meet, found without any hierarchy: each ray with each triangle or ball, by the kernels' own
/// functions (glsl/draw/exact/rays/ray_shapes.glsl as C++).
struct RayTwin {
  glm::vec3 low{0}, high{0};           ///< bounds of all that there is (m)
  std::span<const glm::uvec4> sorted;  ///< as glsl/draw/exact/rays/order.comp writes them

  struct Hit {
    float t = 0;
    int at = -1;  ///< place in the order
    glm::vec2 weight{0};
    bool operator==(const Hit&) const = default;
  };
  [[nodiscard]] Hit nearestTriangle(glm::vec3 origin, glm::vec3 along, float far) const;
  [[nodiscard]] Hit nearestBall(glm::vec3 origin, glm::vec3 along, float far) const;
  /// The first of these by way of the tree of boxes (glsl/draw/exact/rays/walk.glsl as C++).
  [[nodiscard]] Hit walked(std::span<const glm::uvec4> nodes, int leaves, glm::vec3 origin, glm::vec3 along,
                           float far) const;
  /// The box of what lies between these corners, as a hierarchy's nodes have it.
  [[nodiscard]] glm::uvec3 boxOf(glm::vec3 from, glm::vec3 to) const;
};
