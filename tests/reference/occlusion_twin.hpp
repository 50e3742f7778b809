#pragma once
#include "draw/exact/exact_view.hpp"
#include "draw/frame_values.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// CPU twin of ambient occlusion. It runs the shader files as C++, row by row over pixels of half
/// resolution.
struct OcclusionTwin {
  simreel::shader::ExactView view;
  glm::vec3 reach{0};  ///< result of draw::searchLimits()
  int slices = 2, steps = 5;
  std::vector<float> nearness;  ///< 1/depth of half-resolution pixels (1/m)

  [[nodiscard]] glm::ivec2 half() const { return (view.size + 1) / 2; }
  /// Computes `nearness` from the depth keys of the picture's samples. Takes the ground from `ground`,
  /// because the keys do not contain it.
  void see(const simreel::shader::Frame& frame, int samples, const std::vector<std::uint32_t>& keys,
           bool ground);
  /// Returns the openness of each half-resolution pixel, from 0 (fully occluded) to 1 (not occluded).
  [[nodiscard]] std::vector<float> openness() const;
  /// Returns the interpolated openness for shading point `p` (metres) at `pixel` of the full-size picture.
  [[nodiscard]] float opennessOn(const std::vector<float>& openness, glm::ivec2 pixel, glm::vec3 p) const;
};
