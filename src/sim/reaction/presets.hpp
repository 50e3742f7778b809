#pragma once
#include "sim/reaction/parameters.hpp"

#include <span>
#include <string>

namespace simreel::sim {

/// Named set of equations.
struct ReactionPreset {
  const char* name;
  const char* source;  ///< Publication that defines the equations.
  struct Species {
    const char* name;
    float diffusion;
    const char* rate;
    const char* start;
  };
  std::vector<Species> species;
  std::vector<std::pair<const char*, float>> parameters = {};
  std::vector<std::pair<const char*, const char*>> lets = {};
  double spacing = 1;
  double dt;
  int steps;
  RuleMethod method = RuleMethod::euler;
  const char* show = "";  ///< Expression to display; if empty, the first species.
  const char* map;
  double low, high;  ///< Values at the ends of the colour map.

  /// Sets the parameters to this preset.
  void apply(ReactionParameters& parameters) const;
};

[[nodiscard]] std::span<const ReactionPreset> reactionPresets();

/// Returns the text that `simreel list` prints for all presets: equations in C syntax, parameters, source.
[[nodiscard]] std::string reactionPresetsText();

}  // namespace simreel::sim
