#pragma once
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// Ray hits without a BVH: tests each ray with each triangle or sphere, with the kernels' functions
/// (glsl/draw/exact/rays/ray_shapes.glsl as C++).
struct RayTwin {
  glm::vec3 low{0}, high{0};  ///< bounds of the scene (m)
  std::span<const glm::uvec4>
      sorted;  ///< primitives in the layout that glsl/draw/exact/rays/order.comp writes

  struct Hit {
    float t = 0;
    int at = -1;  ///< index in `sorted`
    glm::vec2 weight{0};
    bool operator==(const Hit&) const = default;
  };
  [[nodiscard]] Hit nearestTriangle(glm::vec3 origin, glm::vec3 along, float far) const;
  [[nodiscard]] Hit nearestBall(glm::vec3 origin, glm::vec3 along, float far) const;
  /// Finds the nearest triangle through the BVH (glsl/draw/exact/rays/walk.glsl as C++).
  [[nodiscard]] Hit walked(std::span<const glm::uvec4> nodes, int leaves, glm::vec3 origin, glm::vec3 along,
                           float far) const;
  /// Returns the box between two corners in the packed form of a BVH node.
  [[nodiscard]] glm::uvec3 boxOf(glm::vec3 from, glm::vec3 to) const;
};
