#pragma once
#include "reference/wind_twin.hpp"
#include "sim/fluid/tracers.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

/// CPU twin of tracers. It runs the kernels' own model (glsl/fluid/tracers/tracer_model.glsl compiled as
/// C++).
class TracersTwin {
 public:
  /// `solid`: one byte per cell, which is nonzero inside obstacles.
  TracersTwin(const simreel::sim::TracerParameters& parameters, glm::ivec2 size,
              std::vector<std::uint8_t> solid, const simreel::shader::TracerStep& step,
              double frameSeconds);
  void beginFrame();
  void advance(const WindTwin& wind);

  std::vector<glm::vec4> tracers;    ///< xy: position in cells; z: age in seconds; w: number of rebirths
  std::vector<std::uint32_t> trail;  ///< brightness, one value per cell, x fastest

 private:
  glm::ivec2 size_;
  std::vector<std::uint8_t> solid_;
  simreel::shader::TracerStep step_;
  float kept_;
};
