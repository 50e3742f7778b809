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

/// Parameters common to epidemics and wildfires: a grid of byte cells, a step rate that is independent of
/// the frame rate, strokes, and a chart of the counts.
struct SpreadParameters : scene::Covering {
  enum class Border { torus, closed };
  /// Size of the small grid that replaces a grid of gigabytes when a scene is validated.
  static constexpr glm::ivec2 validationPlan{512, 512};
  glm::ivec2 size{640, 360};
  Border border = Border::closed;
  double stepsPerSecond = 60;
  std::vector<StrokeParameters> strokes;
  bool chart = false;
  double chartSeconds = 0;  ///< initial length of the chart's x axis in seconds; it grows when needed
  FieldDisplay display;
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  [[nodiscard]] bool hasStates() const override { return true; }
  /// Declares the fields size, border and stepsPerSecond.
  void describeGrid(scene::Fields& fields);
  /// Declares the fields chart, chartSeconds and display. Rejects a colour map, because the simulation
  /// defines the colours.
  void describeLook(scene::Fields& fields);
};

/// Maps frames to steps. Step k covers the scene time [k, k + 1) / stepsPerSecond.
struct Pace {
  double stepsPerSecond = 60;
  double frameSeconds = 1.0 / 60;
  /// Returns the maximum number of steps per frame. Every frame has this number of steps or one less.
  [[nodiscard]] int stepsPerFrame() const;
  struct Steps {
    int count = 0;
    double time = 0;  ///< start of the first step in seconds
  };
  [[nodiscard]] Steps during(double time) const;
};

/// Returns the grey levels (0 to 1) of an image, resampled to a grid, x fastest, with linear interpolation
/// between pixel centres, so that small images give smooth maps. Throws the errors of loadPicture(), in
/// which `what` is the image's purpose.
[[nodiscard]] std::vector<double> smoothLevels(const std::filesystem::path& file, const char* what,
                                               glm::ivec2 grid);
/// Returns four-octave noise (0 to 1) on a grid, from integer hashes of lattice points that are `cells`
/// apart, and cubic interpolation. Plain arithmetic gives the same bits on every machine.
[[nodiscard]] std::vector<double> hashNoise(glm::ivec2 grid, double cells, unsigned seed);
/// Returns a hash of a cell index as a number in [0, 1).
[[nodiscard]] double cellFraction(std::size_t cell, unsigned seed);
/// Returns a probability as the threshold to compare with spreadRandom().
[[nodiscard]] std::uint32_t thresholdOf(double probability);

/// Appends `count` linear RGB colours that are interpolated between evenly spaced stops, from the first to
/// the last.
void appendGradient(std::vector<glm::vec3>& colors, const std::vector<glm::vec3>& stops, int count);

}  // namespace simreel::sim
