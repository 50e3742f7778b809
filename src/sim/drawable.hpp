#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "scene/scene.hpp"

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace simreel::sim {

/// Indexed triangles pulled from buffers by gl_VertexID; nothing is copied. All pointers stay owned by
/// the simulation and live until its next step.
struct Surface {
  const gl::Texture* positions = nullptr;  ///< RGBA32F texel view, one texel a vertex: xyz in m, w unused
  const gl::Texture* normals = nullptr;    ///< RGBA32F texel view, xyz; null for a grid
  const gl::Texture* uvs = nullptr;        ///< RG32F texel view; null for a grid
  /// Width and height of a grid of vertices (x fastest) whose normals come from neighbours and whose
  /// uv = (x/(W-1), y/(H-1)); zero for a mesh.
  glm::ivec2 grid{0, 0};
  int vertexCount = 0;
  const gl::Buffer* indices = nullptr;  ///< 32-bit
  int indexCount = 0;
  glm::mat4 model{1.0F};  ///< rigid, or uniformly scaled
  bool doubleSided = false;
  const scene::Material* material = nullptr;
};

/// What a simulation publishes for drawing: a list per kind, one pass each.
struct Drawables {
  std::vector<Surface> surfaces;
};

}  // namespace simreel::sim
