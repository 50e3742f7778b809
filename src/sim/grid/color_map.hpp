#pragma once
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Names of the colour maps, in the order to list them.
[[nodiscard]] const std::vector<std::string>& colorMapNames();

/// Evenly spaced stops of a colour map, linear RGB; empty for an unknown name. Interpolated linearly they
/// stay within 5/255 (sRGB) of the published map.
/// viridis, magma, inferno, plasma: N. J. Smith, S. van der Walt, E. Firing (CC0). turbo: A. Mikhailov,
/// Google (Apache 2.0). polar: of this program, for what has a sign: dark in the middle, even in lightness
/// to both sides.
[[nodiscard]] std::vector<glm::vec3> colorMapStops(const std::string& name);

/// So many colours from the first of evenly spaced stops to the last, for the palette of a surface.
[[nodiscard]] std::vector<glm::vec4> paletteOf(const std::vector<glm::vec3>& stops, int count);

}  // namespace simreel::sim
