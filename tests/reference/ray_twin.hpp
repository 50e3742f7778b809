#pragma once
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// CPU twin of ray intersection without a hierarchy. It tests each ray against each triangle or ball with
/// the kernels' own functions (glsl/draw/exact/rays/ray_shapes.glsl as C++).
struct RayTwin {
  glm::vec3 low{0}, high{0};           ///< bounds of the whole scene in metres
  std::span<const glm::uvec4> sorted;  ///< primitives in the layout that glsl/draw/exact/rays/order.comp
                                       ///< writes

  struct Hit {
    float t = 0;
    int at = -1;  ///< index of the primitive in `sorted`; -1 for no hit
    glm::vec2 weight{0};
    bool operator==(const Hit&) const = default;
  };
  [[nodiscard]] Hit nearestTriangle(glm::vec3 origin, glm::vec3 along, float far) const;
  [[nodiscard]] Hit nearestBall(glm::vec3 origin, glm::vec3 along, float far) const;
  /// Returns the nearest triangle, found by walking the tree of boxes (glsl/draw/exact/rays/walk.glsl as
  /// C++).
  [[nodiscard]] Hit walked(std::span<const glm::uvec4> nodes, int leaves, glm::vec3 origin, glm::vec3 along,
                           float far) const;
  /// Returns the quantized box with these corners, as the nodes of the hierarchy store it.
  [[nodiscard]] glm::uvec3 boxOf(glm::vec3 from, glm::vec3 to) const;
};
