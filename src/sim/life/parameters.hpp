#pragma once
#include "scene/fitted.hpp"
#include "sim/automata/engine/grid_shape.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

using LifeBorder = GridBorder;

/// Pattern file placed in the initial state: an entry of the list "patterns".
struct LifePattern {
  enum class Flip { none, horizontal, vertical };
  std::filesystem::path file;
  std::optional<glm::ivec2> at;  ///< cell of the pattern's top left corner, after flipping and rotating; if
                                 ///< empty, the pattern is centred
  Flip flip = Flip::none;        ///< flip, applied before the rotation
  int rotate = 0;                ///< rotation in degrees clockwise, a multiple of 90
  void describe(scene::Fields& fields);
};

struct LifeParameters : ObjectParameters, HasColorRange, scene::Covering, scene::Fitted {
  LifeParameters();
  glm::ivec2 size{512, 512};       ///< width and height of the grid in cells
  bool fitted = false;             ///< true if no size is given, so that the size is fitted to the patterns
  std::string rule;                ///< notation or name of the rule; if empty, the rule of the first
                                   ///< pattern that names one, otherwise B3/S23
  std::filesystem::path ruleFile;  ///< rule file, which may be given instead of `rule`
  LifeBorder border = LifeBorder::torus;
  glm::ivec2 shift{0, 0};    ///< see GridShape::shift
  bool borderGiven = false;  ///< if false, the border of the first pattern whose file has one is used
  float fill = 0.3F;         ///< fraction of cells that are alive initially; 0 by default if there are
                             ///< patterns
  bool fillGiven = false;
  std::vector<LifePattern> patterns;
  std::vector<StrokeParameters> strokes;  ///< brush strokes; their value is the painted state
  double stepsPerSecond = 10;
  int trail = 0;  ///< number of steps during which a dead cell remains visible
  bool trailGiven = false;
  bool colorsGiven = false;  ///< true if the scene gives colours; they override the colours of a rule file
  FieldDisplay display;
  void describe(scene::Fields& fields) override;
  void fitPicture(glm::ivec2 picture) override {
    if (!fitted) size = display.fittedGrid(size, picture);
  }
  [[nodiscard]] std::vector<MeasuredRange> measuredRanges() override { return display.measuredRanges(); }
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void leaveRoom(glm::vec2 room) override { display.room = room; }
  [[nodiscard]] Extent covering() const override { return display.covering(); }
  [[nodiscard]] bool hasStates() const override { return true; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t minLargestBufferBytes() const override {
    return std::int64_t{size.x} * size.y / 8;
  }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] GridShape shape() const { return {border, shift}; }

  /// Returns the trail level of a live cell, which is above all levels of dead cells.
  [[nodiscard]] int brightLevel() const { return trail + (trail > 2 ? trail / 3 : 1); }
};

/// Maximum trail length; with it, all levels fit into a byte.
inline constexpr int maxTrail = 191;

}  // namespace simreel::sim
