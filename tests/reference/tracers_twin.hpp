#pragma once
#include "reference/wind_twin.hpp"
#include "sim/fluid/tracers.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

/// Tracers on the CPU: the kernels' model (glsl/fluid/tracers/tracer_model.glsl compiled as C++).
class TracersTwin {
 public:
  /// `solid` has one byte per cell.
  TracersTwin(const simreel::sim::TracerParameters& parameters, glm::ivec2 size,
              std::vector<std::uint8_t> solid, const simreel::shader::TracerStep& step,
              double frameSeconds);
  void beginFrame();
  void advance(const WindTwin& wind);

  std::vector<glm::vec4> tracers;    ///< position (cells), age (s) and number of restarts of each tracer
  std::vector<std::uint32_t> trail;  ///< trail value of each cell, x varies fastest

 private:
  glm::ivec2 size_;
  std::vector<std::uint8_t> solid_;
  simreel::shader::TracerStep step_;
  float kept_;
};
