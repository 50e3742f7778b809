#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/frame_values.hpp"
#include "reference/raster_twin.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

/// A mesh of one material in a scene with ground and sky, without shadows.
struct PictureTwinScene {
  simreel::shader::Frame frame;
  simreel::shader::ExactView view;
  int samples = 4;
  bool doubleSided = false;
  bool ground = true;
  std::vector<glm::vec3> places, normals;  ///< m, and unit
  std::vector<unsigned> indices;
  glm::vec3 color{0.8F};
  float roughness = 0.5F, metallic = 0.0F;
};

/// The shader files of the exact rasterizer as C++, pixel by pixel: RGBA, the top row first.
[[nodiscard]] std::vector<std::uint8_t> pictureTwin(const PictureTwinScene& scene);
