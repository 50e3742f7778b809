#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/frame_values.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// The shader files of ambient occlusion as C++, for each half-resolution pixel, row by row.
struct OcclusionTwin {
  simreel::shader::ExactView view;
  glm::vec3 reach{0};  ///< result of draw::reachOnPicture()
  int slices = 2, steps = 5;
  std::vector<float> nearness;  ///< inverse distance (1/m) of each half-resolution pixel

  [[nodiscard]] glm::ivec2 half() const { return (view.size + 1) / 2; }
  /// Fills `nearness` from depth keys of the picture's samples, which exclude the ground; adds the ground
  /// if `ground` is true.
  void see(const simreel::shader::Frame& frame, int samples, const std::vector<std::uint32_t>& keys,
           bool ground);
  /// Returns the openness of each half-resolution pixel.
  [[nodiscard]] std::vector<float> openness() const;
  /// Returns the openness that shading uses for the point `p` (m) visible at a pixel.
  [[nodiscard]] float opennessOn(const std::vector<float>& openness, glm::ivec2 pixel, glm::vec3 p) const;
};
