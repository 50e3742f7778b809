#pragma once
#include "gl/program.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace simreel::draw {

/// Instead of a layer: what reflections of the scene change of the light.
inline constexpr int shownReflections = -1;

/// Whether smooth things mirror a ground.
[[nodiscard]] inline bool mirrorsGround(const gl::Defines& defines) {
  return std::any_of(defines.begin(), defines.end(),
                     [](const auto& define) { return define.first == "GROUND_BELOW"; });
}

/// Of what is not smooth.
inline void withoutGround(gl::Defines& defines) {
  std::erase_if(defines, [](const auto& define) {
    return define.first == "GROUND_BELOW" || define.first == "GROUND_REFLECTIVE";
  });
}

/// Defines of what shades, changed so that it gives a layer of the picture instead of light (`shownLayers`,
/// counted from 1; 0: as they are), or shownReflections.
[[nodiscard]] inline gl::Defines showing(gl::Defines defines, int layer) {
  if (layer == 0) return defines;
  if (layer == shownReflections) {
    if (!mirrorsGround(defines))  // which is lit then
      std::erase_if(defines,
                    [](const auto& define) { return define.first == "SHADOW" || define.first == "LAMPS"; });
    defines.emplace_back("REFLECTED", "1");
    return defines;
  }
  std::erase_if(defines, [](const auto& define) { return define.first == "RAYS"; });
  defines.emplace_back("SHOWN", std::to_string(layer));
  return defines;
}

}  // namespace simreel::draw
