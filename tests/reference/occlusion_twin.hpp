#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/frame_values.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// The shader files of ambient occlusion as C++, half pixel by half pixel, row by row.
struct OcclusionTwin {
  simreel::shader::ExactView view;
  glm::vec3 reach{0};  ///< draw::reachOnPicture()
  int slices = 2, steps = 5;
  std::vector<float> nearness;  ///< of half pixels (1/m)

  [[nodiscard]] glm::ivec2 half() const { return (view.size + 1) / 2; }
  /// Fills in nearness from keys of the picture's samples, without the ground, which is added if asked for.
  void see(const simreel::shader::Frame& frame, int samples, const std::vector<std::uint32_t>& keys,
           bool ground);
  /// Openness of each half pixel.
  [[nodiscard]] std::vector<float> openness() const;
  /// What shading takes for the place `p` (m) that a pixel of the picture shows.
  [[nodiscard]] float opennessOn(const std::vector<float>& openness, glm::ivec2 pixel, glm::vec3 p) const;
};
