#pragma once
#include "gl/program.hpp"

#include <string>
#include <vector>

namespace simreel::draw {

/// Defines of what shades, changed so that it gives a layer of the picture instead of light (`shownLayers`,
/// counted from 1; 0: as they are).
[[nodiscard]] inline gl::Defines showing(gl::Defines defines, int layer) {
  if (layer == 0) return defines;
  std::erase_if(defines, [](const auto& define) { return define.first == "RAYS"; });
  defines.emplace_back("SHOWN", std::to_string(layer));
  return defines;
}

}  // namespace simreel::draw
