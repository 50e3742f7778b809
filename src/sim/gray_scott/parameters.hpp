#pragma once
#include "scene/value/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Named pairs of rates. src/sim/gray_scott/README.md shows what each grows: "spots" dies out, "leopard"
/// grows spots.
enum class GrayScottPreset { spots, stripes, maze, solitons, unstable, leopard, chaos };

/// Rates at which u is fed and v is removed, per unit of time.
struct FeedKill {
  float feed, kill;
};
[[nodiscard]] FeedKill ratesOf(GrayScottPreset preset);

/// Mixture of the rates of two presets.
struct GrayScottHealth {
  scene::Animated<float> level = 1.0F;  ///< 1: rates of `well`, 0: of `ill`, in between a mixture
  GrayScottPreset well = GrayScottPreset::leopard, ill = GrayScottPreset::chaos;
};

/// Gray-Scott reaction-diffusion as a scene says it.
struct GrayScottParameters : ObjectParameters {
  glm::ivec2 size{256, 256};  ///< cells
  GrayScottPreset preset = GrayScottPreset::leopard;
  std::optional<scene::Animated<float>> feed, kill;  ///< instead of the preset's
  std::optional<GrayScottHealth> health;             ///< instead of preset, feed and kill
  std::optional<double> feedAcross, killDown;        ///< rates at the right and at the bottom edge
  bool axes = false;                                 ///< drawn where they vary so
  std::filesystem::path feedImage, killImage;        ///< fractions of the way to feedWhite, killWhite
  double feedWhite = 0.06, killWhite = 0.065;
  double diffuseU = 0.21, diffuseV = 0.105;  ///< cells^2 per unit of time
  double dt = 1;
  int steps = 16;    ///< per frame
  int presteps = 0;  ///< before everything
  int seedCount = 24;
  double seedRadius = 5;        ///< cells
  double seedValue = 0.5;       ///< of v; u is the rest of 1
  double seedNoise = 0.1;       ///< fraction by which v differs at random within the seeds
  std::filesystem::path image;  ///< light pixels start as seeds do
  std::vector<StrokeParameters> strokes;
  FieldDisplay display;

  GrayScottParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override { return std::int64_t{8} * size.x * size.y; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  /// Rates at `time` (s), before they vary in space.
  [[nodiscard]] FeedKill ratesAt(double time) const;
};

/// Greatest stable dt D: the stencil's fastest mode, the checkerboard of rows, has the eigenvalue -1.6 and
/// an explicit step needs dt D 1.6 <= 2.
inline constexpr double maxGrayScottDiffusion = 1.25;

}  // namespace simreel::sim
