#pragma once
#include "gpu/draw/instance_stage.hpp"

#include <algorithm>

/// A sphere mesh, stored like a surface that a simulation publishes.
struct SphereStage {
  SphereStage(glm::vec3 middle, float radius) {
    constexpr int rings = 64;
    constexpr int sectors = 128;
    std::vector<glm::vec4> points;
    std::vector<glm::vec4> outwards;
    std::vector<glm::vec2> coordinates;
    std::vector<unsigned> corners;
    for (int r = 0; r <= rings; ++r)
      for (int s = 0; s <= sectors; ++s) {
        const float polar = 3.14159265F * static_cast<float>(r) / rings;
        const float turn = 6.28318531F * static_cast<float>(s) / sectors;
        const glm::vec3 n(std::sin(polar) * std::cos(turn), std::cos(polar),
                          -std::sin(polar) * std::sin(turn));
        points.emplace_back(middle + radius * n, 1.0F);
        outwards.emplace_back(n, 0.0F);
        coordinates.emplace_back(0.0F);
      }
    for (unsigned r = 0; r < rings; ++r)
      for (unsigned s = 0; s < sectors; ++s) {
        const unsigned a = r * (sectors + 1) + s;
        const unsigned below = a + sectors + 1;
        corners.insert(corners.end(), {a, below, a + 1, a + 1, below, below + 1});
      }
    positions = simreel::gl::Buffer::of<glm::vec4>("sphere positions", points);
    normals = simreel::gl::Buffer::of<glm::vec4>("sphere normals", outwards);
    uvs = simreel::gl::Buffer::of<glm::vec2>("sphere uvs", coordinates);
    indices = simreel::gl::Buffer::of<unsigned>("sphere indices", corners);
    positionView = simreel::gl::Texture::view("sphere positions", GL_RGBA32F, positions);
    normalView = simreel::gl::Texture::view("sphere normals", GL_RGBA32F, normals);
    uvView = simreel::gl::Texture::view("sphere uvs", GL_RG32F, uvs, 8);
    surface.positions = &positionView;
    surface.normals = &normalView;
    surface.uvs = &uvView;
    surface.vertexCount = static_cast<int>(points.size());
    surface.indices = &indices;
    surface.indexCount = static_cast<int>(corners.size());
    surface.material = &material;
  }
  SphereStage(const SphereStage&) = delete;
  SphereStage& operator=(const SphereStage&) = delete;
  SphereStage(SphereStage&&) = delete;
  SphereStage& operator=(SphereStage&&) = delete;
  ~SphereStage() = default;

  simreel::gl::Buffer positions, normals, uvs, indices;
  simreel::gl::Texture positionView, normalView, uvView;
  simreel::scene::Material material;
  simreel::sim::Surface surface;
};

struct Difference {
  double mean = 0;  ///< mean absolute difference of all channels
  int far = 0;      ///< number of pixels with a channel that differs by more than 24
};

inline Difference compare(const Picture& a, const Picture& b) {
  Difference difference;
  for (int y = 0; y < a.size.y; ++y)
    for (int x = 0; x < a.size.x; ++x) {
      const glm::ivec3 d = glm::abs(a.at(x, y) - b.at(x, y));
      difference.mean += (d.x + d.y + d.z) / 3.0;
      difference.far += std::max({d.x, d.y, d.z}) > 24 ? 1 : 0;
    }
  difference.mean /= a.size.x * a.size.y;
  return difference;
}
