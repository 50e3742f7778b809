#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// HDR image as stored in a file: RGBA per pixel, rows from the top.
struct LightFile {
  /// Maximum width and height in pixels. Files with larger sizes are rejected as damaged.
  static constexpr int largestSide = 16384;

  glm::ivec2 size{0, 0};
  std::vector<float> values;
  std::string colours;  ///< description of the primaries; empty for the primaries of Rec. 709
  std::string note;     ///< content of the file that was not read, for example "channels Z"; empty if
                        ///< everything was read
  std::string unfit;    ///< reason why the image is not an environment map; empty if it may be one
};

/// Return true if the bytes begin like a file of the format.
[[nodiscard]] bool isRadiance(std::string_view bytes);
[[nodiscard]] bool isExr(std::string_view bytes);

// Decodes an image. Throws UserError(inputOutput) for unreadable bytes. The message begins with `label`
// (such as "baseline a.exr") and, for a truncated file, ends with `advice`.
[[nodiscard]] LightFile decodeRadiance(std::string_view bytes, const std::string& label,
                                       const std::string& advice);
[[nodiscard]] LightFile decodeExr(std::string_view bytes, const std::string& label,
                                  const std::string& advice);

}  // namespace simreel::sim
