#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// A picture of light as a file has it, RGBA of each pixel, rows from the top.
struct LightFile {
  static constexpr int largestSide = 16384;  ///< what claims more is damaged

  glm::ivec2 size{0, 0};
  std::vector<float> values;
  std::string colours;  ///< primaries as text; empty for those of Rec. 709
  std::string note;     ///< what of the file is not in it: "channels Z"; or empty
  std::string unfit;    ///< why it is no picture of all around; or empty
};

/// Whether a file begins as one of these.
[[nodiscard]] bool isRadiance(std::string_view bytes);
[[nodiscard]] bool isExr(std::string_view bytes);

// `label` ("baseline a.exr") is first in the UserError(inputOutput) thrown for what cannot be read,
// `advice` last in that for what was cut off.
[[nodiscard]] LightFile decodeRadiance(std::string_view bytes, const std::string& label,
                                       const std::string& advice);
[[nodiscard]] LightFile decodeExr(std::string_view bytes, const std::string& label,
                                  const std::string& advice);

}  // namespace simreel::sim
