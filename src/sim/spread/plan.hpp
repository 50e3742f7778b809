#pragma once
#include "scene/value/fields.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#define FUNCTION inline
namespace simreel::shader {
#include "glsl/spread/cells.glsl"
}
#undef FUNCTION

namespace simreel::sim {

/// What an epidemic and a wildfire have in common: a grid of cells in bytes, steps apart from the frame
/// rate, strokes, a chart of the counts.
struct SpreadParameters {
  enum class Border { torus, closed };
  /// Size of a grid that is made to find the mistakes of one that takes gigabytes.
  static constexpr glm::ivec2 lookedAt{512, 512};
  glm::ivec2 size{640, 360};
  Border border = Border::closed;
  double stepsPerSecond = 60;
  std::vector<StrokeParameters> strokes;
  bool chart = false;
  double chartSeconds = 0;  ///< s on the chart's x axis, which grows when they are over
  FieldDisplay display;
  /// size, border, stepsPerSecond.
  void describeGrid(scene::Fields& fields);
  /// chart, chartSeconds, display. Its colours are those of the simulation: a map is refused.
  void describeLook(scene::Fields& fields);
};

/// Which steps a frame takes. Step k covers [k, k + 1) / stepsPerSecond of scene time.
struct Pace {
  double stepsPerSecond = 60;
  double frameSeconds = 1.0 / 60;
  /// Steps of a frame at most; every frame has so many, or one less.
  [[nodiscard]] int stepsPerFrame() const;
  struct Steps {
    int count = 0;
    double time = 0;  ///< s when the first of them begins
  };
  [[nodiscard]] Steps during(double time) const;
};

/// Grey levels 0 to 1 of a picture on a grid, x fastest, linear between the middles of its pixels: small
/// pictures make smooth maps. `what` names its use in errors, which are those of loadPicture.
[[nodiscard]] std::vector<double> smoothLevels(const std::filesystem::path& file, const char* what,
                                               glm::ivec2 grid);
/// Noise of four octaves on a grid, 0 to 1, from integer hashes of lattice points `cells` apart and cubic
/// blending: plain arithmetic, the same on every machine.
[[nodiscard]] std::vector<double> hashNoise(glm::ivec2 grid, double cells, unsigned seed);
/// A hash of a cell as a number in [0, 1).
[[nodiscard]] double cellFraction(std::size_t cell, unsigned seed);
/// A probability as a threshold of spreadRandom().
[[nodiscard]] std::uint32_t thresholdOf(double probability);

/// Colours between stops at whole places, linear RGB: `count` of them from the first to the last.
void appendGradient(std::vector<glm::vec3>& colors, const std::vector<glm::vec3>& stops, int count);

}  // namespace simreel::sim
