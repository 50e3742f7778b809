#pragma once
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/field_stage.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <functional>
#include <numbers>
#include <string>
#include <vector>

/// A mesh, stored like a surface that a simulation publishes. The surface has uvs only if the mesh has
/// them.
struct MeshStage {
  explicit MeshStage(const simreel::sim::Mesh& mesh) {
    std::vector<glm::vec4> places;
    std::vector<glm::vec4> directions;
    for (const glm::vec3& p : mesh.positions) places.emplace_back(p, 1.0F);
    for (const glm::vec3& n : mesh.normals) directions.emplace_back(n, 0.0F);
    positions = simreel::gl::Buffer::of<glm::vec4>("positions", places);
    normals = simreel::gl::Buffer::of<glm::vec4>("normals", directions);
    indices = simreel::gl::Buffer::of<unsigned>("indices", mesh.indices);
    positionView = simreel::gl::Texture::view("positions", GL_RGBA32F, positions);
    normalView = simreel::gl::Texture::view("normals", GL_RGBA32F, normals);
    if (!mesh.uvs.empty()) {
      uvs = simreel::gl::Buffer::of<glm::vec2>("uvs", mesh.uvs);
      uvView = simreel::gl::Texture::view("uvs", GL_RG32F, uvs, sizeof(glm::vec2));
      surface.uvs = &uvView;
    }
    surface.positions = &positionView;
    surface.normals = &normalView;
    surface.vertexCount = static_cast<int>(places.size());
    surface.indices = &indices;
    surface.indexCount = static_cast<int>(mesh.indices.size());
    surface.material = &material;
  }
  MeshStage(const MeshStage&) = delete;
  MeshStage& operator=(const MeshStage&) = delete;
  MeshStage(MeshStage&&) = delete;
  MeshStage& operator=(MeshStage&&) = delete;
  ~MeshStage() = default;

  simreel::gl::Buffer positions, normals, uvs, indices;
  simreel::gl::Texture positionView, normalView, uvView;
  simreel::scene::Material material;
  simreel::sim::Surface surface;
};

/// Returns a square with sides of 2 m in the plane z = 0 that faces +z. v increases downwards. u increases
/// to the right, or to the left if `mirrored` is true.
inline simreel::sim::Mesh squareMesh(bool mirrored = false) {
  simreel::sim::Mesh mesh;
  for (const float y : {1.0F, -1.0F})
    for (const float x : {-1.0F, 1.0F}) {
      mesh.positions.emplace_back(x, y, 0);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.uvs.emplace_back(mirrored ? 0.5F - 0.5F * x : 0.5F + 0.5F * x, 0.5F - 0.5F * y);
    }
  mesh.indices = {0, 2, 1, 1, 2, 3};
  return mesh;
}

/// Returns a smooth, periodic, asymmetric sum of waves, from 0 to 1.
inline double waves(double u, double v) {
  constexpr double turn = 2 * std::numbers::pi;
  return 0.5 + 0.2 * std::sin(turn * (3 * u + v)) + 0.17 * std::sin(turn * (2 * v - u) + 0.7) +
         0.12 * std::sin(turn * (5 * u + 4 * v) + 2.1);
}

/// Returns a material with a skin of the field "grid" (the name of a FieldStage's field).
inline simreel::scene::Material grown(simreel::scene::Skin::Look look) {
  simreel::scene::Material material;
  material.skin.emplace();
  material.skin->field = "grid";
  material.skin->look = look;
  return material;
}

/// Returns a dark scene that has one object with the material.
inline simreel::scene::Scene roomWith(const simreel::scene::Material& material) {
  simreel::scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  scene.objects.emplace_back();
  scene.objects.back().name = "wearer";
  scene.objects.back().material = material;
  return scene;
}

/// Returns the max difference of any channel between two pictures.
inline int maxDifference(const Picture& a, const Picture& b) {
  int max = 0;
  for (std::size_t i = 0; i < a.bytes.size(); ++i) max = std::max(max, std::abs(a.bytes[i] - b.bytes[i]));
  return max;
}
