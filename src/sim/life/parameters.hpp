#pragma once
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

/// A pattern file set into the first state: an entry of the list "patterns".
struct LifePattern {
  enum class Flip { none, horizontal, vertical };
  std::filesystem::path file;
  std::optional<glm::ivec2>
      at;                  ///< cell of its top left corner, after flipping and turning; else the middle
  Flip flip = Flip::none;  ///< before it is turned
  int rotate = 0;          ///< degrees clockwise, a multiple of 90
  void describe(scene::Fields& fields);
};

struct LifeParameters : ObjectParameters {
  LifeParameters();
  glm::ivec2 size{512, 512};       ///< cells
  bool fitted = false;             ///< the size is not given: it fits the patterns
  std::string rule;                ///< empty: of the first pattern that names one, else B3/S23
  std::filesystem::path ruleFile;  ///< instead of a rule
  LifeBorder border = LifeBorder::torus;
  glm::ivec2 shift{0, 0};    ///< GridShape::shift
  bool borderGiven = false;  ///< else that of the first pattern whose file has one
  float fill = 0.3F;         ///< fraction alive at the start; not given beside patterns: 0
  bool fillGiven = false;
  std::vector<LifePattern> patterns;
  std::vector<StrokeParameters> strokes;  ///< value: the state painted
  double stepsPerSecond = 10;
  int trail = 0;  ///< steps for which a dead cell is still seen
  bool trailGiven = false;
  bool colorsGiven = false;  ///< by the scene, which goes before a rule file
  FieldDisplay display;
  void describe(scene::Fields& fields) override;
  [[nodiscard]] const char* drawnWith() const override { return "its \"display\""; }
  void ports(Ports& ports) const override;
  [[nodiscard]] std::int64_t leastBlockBytes() const override { return std::int64_t{size.x} * size.y / 8; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;
  [[nodiscard]] GridShape shape() const { return {border, shift}; }

  /// Level of a living cell in the trail, above all levels of dead ones.
  [[nodiscard]] int brightLevel() const { return trail + (trail > 2 ? trail / 3 : 1); }
};

/// Longest trail: its levels and that of the living fit into a byte.
inline constexpr int maxTrail = 191;

}  // namespace simreel::sim
