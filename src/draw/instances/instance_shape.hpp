#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::draw {

/// The shape that instances repeat, on the device. Index values are copy << vertexBits | vertex and each
/// level's indices hold `batch` copies (glsl/draw/instances/instance_pull.glsl says why).
class InstanceShape {
 public:
  struct Level {
    GLenum mode = GL_TRIANGLES;
    int firstIndex = 0;
    int indexCount = 0;  ///< of all copies
    int batch = 1;
    float swell = 0;  ///< of spheres: fraction of the radius by which facets lie below the corners
  };

  /// No vertex data, diameter 1. Level 0, for sprites of few pixels, is a point, or a square where `points`
  /// is false; level 1 is a square with corners 0 to 3.
  static InstanceShape sprite(bool points);
  /// Icospheres whose outlines have the area of a disc of diameter 1 in the mean: level n has 20 * 4^n
  /// triangles.
  static InstanceShape sphere();
  /// Triangles with unit normals per vertex.
  static InstanceShape mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                            std::span<const unsigned> indices);

  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  [[nodiscard]] int vertexBits() const { return vertexBits_; }
  [[nodiscard]] float radius() const { return radius_; }  ///< m, of a ball around the origin
  [[nodiscard]] const gl::Buffer& indices() const { return indices_; }
  /// RGBA32F, two texels a vertex: position, normal. Empty for the square.
  [[nodiscard]] const gl::Texture& vertices() const { return view_; }

 private:
  struct Builder;
  std::vector<Level> levels_;
  int vertexBits_ = 0;
  float radius_ = 0.5F;
  gl::Buffer indices_, vertices_;
  gl::Texture view_;
};

}  // namespace simreel::draw
