#pragma once
#include "scene/scene.hpp"
#include "sim/core/simulation.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::sim {

class World;

/// Minimum and maximum of the values that a colour range must span, over the frames sampled so far.
struct SeenRange {
  std::size_t object = 0;  ///< index of the object in the scene
  std::size_t range = 0;   ///< index of the range in HasColorRange::measuredRanges()
  float low = 0, high = 0;
  bool seen = false;  ///< false until a finite value is found
};

/// Returns one entry, still without extremes, for each colour range of the scene that has an "auto" end.
[[nodiscard]] std::vector<SeenRange> rangesToSee(scene::Scene& scene);
/// Returns true if a colour range of the scene has an "auto" end.
[[nodiscard]] bool needsRanges(scene::Scene& scene);

/// Extends the ranges by the values of the world's current frame: all cells of a displayed field, the
/// speeds, masses or ages of all live particles, or the values of all vertices of a coloured surface.
/// Ignores infinite values and NaN. Waits for the GPU.
void seeValues(const World& world, std::vector<SeenRange>& ranges);

/// Sets the measured ends of the scene's colour ranges. If both ends would be equal, moves the measured
/// ones apart. Returns overrides "path=value" that reproduce the ends.
std::vector<std::string> setRanges(scene::Scene& scene, const std::vector<SeenRange>& ranges);

}  // namespace simreel::sim
