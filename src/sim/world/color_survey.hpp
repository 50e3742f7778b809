#pragma once
#include "scene/scene.hpp"
#include "sim/core/simulation.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace simreel::sim {

class World;

/// Extremes of the values that a range of colours must span, over the frames seen so far.
struct SeenRange {
  std::size_t object = 0;  ///< index of the object in the scene
  std::size_t range = 0;   ///< index of the range in HasColorRange::measuredRanges()
  float low = 0, high = 0;
  bool seen = false;  ///< false: no finite value so far
};

/// Returns the ranges of a scene that are "auto", without extremes.
[[nodiscard]] std::vector<SeenRange> rangesToSee(scene::Scene& scene);
/// True if the scene has a range that is "auto".
[[nodiscard]] bool needsRanges(scene::Scene& scene);

/// Extends the ranges by the values of the world's present frame: all cells of a displayed field, the
/// speeds, masses or ages of all living particles, or the values of all vertices of a coloured surface.
/// Infinite values and NaN do not count. Waits for the GPU.
void seeValues(const World& world, std::vector<SeenRange>& ranges);

/// Sets the measured ends of the scene's ranges. If the ends would be equal, the measured ones move apart.
/// Returns overrides "path=value" that give the same ends.
std::vector<std::string> setRanges(scene::Scene& scene, const std::vector<SeenRange>& ranges);

}  // namespace simreel::sim
