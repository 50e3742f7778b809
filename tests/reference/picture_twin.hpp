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
  std::vector<std::vector<glm::uvec3>> levels;  ///< linear light in units of 1/65535; one array per mip
                                                ///< level
  glm::vec2 scale{1};                           ///< number of repeats along u and v
  std::vector<glm::vec2> uvs;                   ///< one element per vertex
};

/// A mesh with one material in a scene with ground and sky, without shadows.
struct PictureTwinScene {
  simreel::shader::Frame frame;
  simreel::shader::ExactView view;
  int samples = 4;
  bool doubleSided = false;
  bool ground = true;
  std::vector<glm::vec3> places, normals;  ///< positions in metres, and unit normals
  std::vector<unsigned> indices;
  glm::vec3 color{0.8F};
  float roughness = 0.5F, metallic = 0.0F;
  TwinTexture texture;  ///< texture; unused if it has no mip levels
};

/// Draws the scene pixel by pixel with the exact rasterizer's shader files compiled as C++. Returns RGBA
/// bytes, top row first.
[[nodiscard]] std::vector<std::uint8_t> pictureTwin(const PictureTwinScene& scene);
