#pragma once
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the names of the colour maps in display order.
[[nodiscard]] const std::vector<std::string>& colorMapNames();

/// Returns the evenly spaced linear RGB stops of a colour map; empty for an unknown name. Linear
/// interpolation between the stops stays within 5/255 (sRGB) of the published map. viridis, magma, inferno
/// and plasma are by N. J. Smith, S. van der Walt and E. Firing (CC0), turbo by A. Mikhailov, Google
/// (Apache 2.0). polar is a map of this program for signed values; it is dark in the middle, and its
/// lightness increases evenly to both sides.
[[nodiscard]] std::vector<glm::vec3> colorMapStops(const std::string& name);

/// Returns `count` colours interpolated from evenly spaced stops, from the first to the last, for a
/// surface's palette.
[[nodiscard]] std::vector<glm::vec4> paletteOf(const std::vector<glm::vec3>& stops, int count);

}  // namespace simreel::sim
