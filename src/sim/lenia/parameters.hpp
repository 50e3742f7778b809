#pragma once
#include "scene/fitted.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Ring-shaped kernel, and the growth function applied to its weighted sums: an entry of "kernels".
struct LeniaKernel {
  enum class Core { polynomial, exponential };
  enum class Growth { polynomial, gaussian, step };
  double radius = 13;            ///< radius in cells
  std::vector<int> rings{100};   ///< heights, in percent, of rings of equal width, from the centre outwards
  Core core = Core::polynomial;  ///< profile of a ring at the position r (0 to 1) across it: (4 r (1 -
                                 ///< r))^4 or exp(4 - 1 / (r (1 - r)))
  Growth growth = Growth::polynomial;
  double mu = 0.15, sigma = 0.015;
  double weight = 1;
  void describe(scene::Fields& fields);
};

/// Creature placed in the initial state.
struct LeniaCreature {
  int kind = 0;  ///< index into leniaCreatures()
  std::optional<glm::ivec2> at;
  int rotate = 0;
  bool mirrored = false;
  void describe(scene::Fields& fields);
};

struct LeniaParameters : ObjectParameters, HasColorRange, scene::Covering, scene::Fitted {
  enum class Model { lenia, smoothLife };
  LeniaParameters();
  glm::ivec2 size{256, 144};  ///< width and height of the grid (a torus) in cells
  Model model = Model::lenia;
  std::vector<LeniaKernel> kernels{LeniaKernel{}};
  double timeScale = 10;  ///< number of steps per unit of time
  double stepsPerSecond = 30;
  double radius = 12;  ///< outer radius in cells of the ring of SmoothLife; the radius of the disc is a
                       ///< third of it
  double bornMin = 0.278, bornMax = 0.365, surviveMin = 0.267, surviveMax = 0.445;
  double alphaRing = 0.028, alphaDisc = 0.147;
  std::vector<LeniaCreature> creatures;
  int patches = 24;  ///< number of squares with random values at random positions
  std::vector<StrokeParameters> strokes;
  FieldDisplay display;
  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override { size = display.fittedGrid(size, picture); }
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return display.measuredRanges(); }
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{4} * size.x * size.y;
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
};

/// Named creature. Each character of its rows is a cell: a base-62 digit in units of 1/61.
struct LeniaShape {
  const char* name;
  std::vector<const char*> rows;
};
[[nodiscard]] const std::vector<LeniaShape>& leniaCreatures();
/// Returns the value of a base-62 digit as a fraction from 0 to 1.
[[nodiscard]] float leniaDigit(char digit);

inline constexpr int maxLeniaRadius = 48;

}  // namespace simreel::sim
