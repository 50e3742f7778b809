#pragma once
#include "scene/fitted.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Named pairs of rates. src/sim/gray_scott/README.md shows the pattern of each pair. With "spots" every
/// pattern dies out; "leopard" gives spots.
enum class GrayScottPreset { spots, stripes, maze, solitons, unstable, leopard, chaos };

/// Feed rate of u and removal rate of v, per unit of time.
struct FeedKill {
  float feed, kill;
};
[[nodiscard]] FeedKill ratesOf(GrayScottPreset preset);

/// Blend of the rates of two presets.
struct GrayScottHealth {
  scene::Animated<float> level =
      1.0F;  ///< Blend factor: 1 gives the rates of `well`, 0 the rates of `ill`.
  GrayScottPreset well = GrayScottPreset::leopard, ill = GrayScottPreset::chaos;
};

/// Scene parameters of Gray-Scott reaction-diffusion.
struct GrayScottParameters : ObjectParameters, HasColorRange, scene::Covering, scene::Fitted {
  glm::ivec2 size{256, 256};  ///< Grid size in cells.
  GrayScottPreset preset = GrayScottPreset::leopard;
  std::optional<scene::Animated<float>> feed,
      kill;                               ///< Feed rate and kill rate that replace the rates of the preset.
  std::optional<GrayScottHealth> health;  ///< Blended rates that replace preset, feed and kill.
  std::optional<double> feedAcross,
      killDown;       ///< Feed rate at the right edge, and kill rate at the bottom edge.
  bool axes = false;  ///< True to draw axes along which the rates vary.
  std::filesystem::path feedImage,
      killImage;  ///< Images whose brightness interpolates the rates towards feedWhite and killWhite.
  double feedWhite = 0.06, killWhite = 0.065;
  double diffuseU = 0.21, diffuseV = 0.105;  ///< Diffusion coefficients in cells^2 per unit of time.
  double dt = 1;
  int steps = 16;    ///< Number of steps per frame.
  int presteps = 0;  ///< Number of steps before the first frame.
  int seedCount = 24;
  double seedRadius = 5;        ///< Radius of a seed in cells.
  double seedValue = 0.5;       ///< Initial value of v in a seed; u is 1 - v.
  double seedNoise = 0.1;       ///< Amplitude of random variation of v within seeds, as a fraction.
  std::filesystem::path image;  ///< Image whose bright pixels are initialized like seeds.
  std::vector<StrokeParameters> strokes;
  FieldDisplay display;

  GrayScottParameters();
  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override { size = display.fittedGrid(size, picture); }
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return display.measuredRanges(); }
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{8} * size.x * size.y;
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  /// Returns the rates at `time` (seconds), without spatial variation.
  [[nodiscard]] FeedKill ratesAt(double time) const;
};

/// Maximum of dt D (step times diffusion coefficient) for stability. The stencil's fastest mode,
/// alternating rows, has the eigenvalue -1.6, and an explicit step requires dt D 1.6 <= 2.
inline constexpr double maxGrayScottDiffusion = 1.25;

}  // namespace simreel::sim
