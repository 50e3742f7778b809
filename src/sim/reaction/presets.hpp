#pragma once
#include "sim/reaction/parameters.hpp"

#include <span>
#include <string>

namespace simreel::sim {

/// Equations by name.
struct ReactionPreset {
  const char* name;
  const char* source;  ///< where they are from
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
  const char* show = "";  ///< empty: the first species
  const char* map;
  double low, high;  ///< of the colours

  /// Puts them in.
  void apply(ReactionParameters& parameters) const;
};

[[nodiscard]] std::span<const ReactionPreset> reactionPresets();

/// All of them as simreel list shows them: equations as C would have them, parameters, source.
[[nodiscard]] std::string reactionPresetsText();

}  // namespace simreel::sim
