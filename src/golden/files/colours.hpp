#pragma once
#include <string>
#include <string_view>

namespace simreel::golden {

/// Returns a description of how a PNG, JPEG or Radiance file declares its values to be interpreted: "the
/// colour profile Display P3 (1f0c9d3a)", "gamma 1", "turned (Exif orientation 6)", "EXPOSURE=2". Returns
/// an empty text if the file declares nothing or the default (sRGB). Pictures are compared by their raw
/// values, so two files with equal values but different descriptions look different on a screen.
[[nodiscard]] std::string colourWords(std::string_view bytes);

}  // namespace simreel::golden
