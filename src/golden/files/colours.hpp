#pragma once
#include <string>
#include <string_view>

namespace simreel::golden {

/// What a file says that its numbers mean, in words: "the colour profile Display P3 (1f0c9d3a)", "gamma 1",
/// "turned (Exif orientation 6)", "EXPOSURE=2". Empty where it says nothing or what everybody assumes
/// (sRGB). Of PNG, JPEG and Radiance files; numbers are compared as they are, so that two files that differ
/// here look different, though their numbers are equal.
[[nodiscard]] std::string colourWords(std::string_view bytes);

}  // namespace simreel::golden
