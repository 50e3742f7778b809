#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::draw {

/// The shape of instances, in GPU buffers. An index value is copy << vertexBits | vertex. The indices of
/// each level contain `batch` copies. glsl/draw/instances/instance_pull.glsl explains why.
class InstanceShape {
 public:
  struct Level {
    GLenum mode = GL_TRIANGLES;
    int firstIndex = 0;
    int indexCount = 0;  ///< number of indices of all copies
    int batch = 1;
    float swell = 0;  ///< for spheres only: distance from the sphere through the corners to the facet
                      ///< centres, as a fraction of the radius
  };

  /// Returns a sprite of diameter 1, without vertex data. Level 0, for sprites of a few pixels, is a point,
  /// or a square if `points` is false. Level 1 is a square with corners 0 to 3.
  static InstanceShape sprite(bool points);
  /// Returns icospheres whose outlines have, on average, the area of a disc of diameter 1. Level n has 20 *
  /// 4^n triangles.
  static InstanceShape sphere();
  /// Returns a triangle mesh with unit normals per vertex.
  static InstanceShape mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                            std::span<const unsigned> indices);

  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  [[nodiscard]] int vertexBits() const { return vertexBits_; }
  /// Returns the radius of the bounding sphere around the origin (m).
  [[nodiscard]] float radius() const { return radius_; }
  [[nodiscard]] const gl::Buffer& indices() const { return indices_; }
  /// Returns two RGBA32F texels per vertex: position, normal. Empty for sprites.
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
