#pragma once
#include "scene/fields.hpp"
#include "sim/core/kind.hpp"
#include "sim/grid/field_display.hpp"
#include "sim/grid/strokes.hpp"
#include "sim/reaction/evaluate.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

struct ReactionSpecies {
  std::string name;
  scene::Animated<float> diffusion = 0.0F;  ///< D of D lap(u), lengths^2 per unit of time
  std::string rate = "0";                   ///< the rest of du/dt
  std::string start = "0";                  ///< in the first state
  double edge = 0;                          ///< beyond edges that are fixed
};

struct ReactionParameter {
  std::string name;
  scene::Animated<float> value = 0.0F;
  std::optional<double> across, down;  ///< value at the right, or at the bottom edge
  std::filesystem::path image;         ///< share of the way to `white`
  double white = 1;
  bool isPresets = false;  ///< so that expressions may do without it

  [[nodiscard]] bool isMapped() const { return across || down || !image.empty(); }
};

struct ReactionLet {
  std::string name, is = "0";
};

struct ReactionStroke : StrokeParameters {
  std::string species;  ///< empty: the first
};

/// Equations of one's own as a scene says them: du/dt = D lap(u) + rate for each species.
struct ReactionParameters : ObjectParameters {
  glm::ivec2 size{256, 256};  ///< cells
  int preset = -1;
  double spacing = 1;  ///< of cells, units of length
  double dt = 0.1;     ///< units of time
  int steps = 8;       ///< per frame
  int presteps = 0;    ///< before everything
  RuleMethod method = RuleMethod::euler;
  RuleBoundary boundary = RuleBoundary::torus;
  std::vector<ReactionSpecies> species;
  std::vector<ReactionParameter> parameters;
  std::vector<ReactionLet> lets;
  std::string show;  ///< an expression; empty: the first species
  std::vector<ReactionStroke> strokes;
  FieldDisplay display;

  ReactionParameters();
  void describe(scene::Fields& fields) override;
  [[nodiscard]] bool isField() const override { return true; }
  [[nodiscard]] std::span<const scene::Quantity> quantities() const override;

  [[nodiscard]] RuleText ruleText() const;
  /// The species that a stroke paints; -1: there is none of that name.
  [[nodiscard]] int painted(const ReactionStroke& stroke) const;
};

}  // namespace simreel::sim
