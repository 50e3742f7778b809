#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/frame_values.hpp"
#include "reference/raster_twin.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// A texture of the mesh.
struct TwinTexture {
  glm::ivec2 size{0};
  std::vector<std::vector<glm::uvec3>> levels;  ///< mip levels with linear light in units of 1/65535
  glm::vec2 scale{1};                           ///< repetitions of the texture along u and v
  std::vector<glm::vec2> uvs;                   ///< texture coordinates of the vertices
};

/// A mesh of one material in a scene with ground and sky, without shadows.
struct PictureTwinScene {
  simreel::shader::Frame frame;
  simreel::shader::ExactView view;
  int samples = 4;
  bool doubleSided = false;
  bool ground = true;
  std::vector<glm::vec3> places, normals;  ///< vertex positions in m, and unit normals
  std::vector<unsigned> indices;
  glm::vec3 color{0.8F};
  float roughness = 0.5F, metallic = 0.0F;
  TwinTexture texture;  ///< texture of the mesh; without mip levels: no texture
};

/// Returns RGBA pixels, top row first, drawn by the shader files of the exact rasterizer as C++.
[[nodiscard]] std::vector<std::uint8_t> pictureTwin(const PictureTwinScene& scene);
