#include "reference/overlay_twin.hpp"

#include "draw/picture_code.hpp"

#include <bit>
#include <utility>

namespace simreel::shader {

namespace {

using glm::ceil;
using glm::uvec2;

float uintBitsToFloat(uint word) {
  return std::bit_cast<float>(word);
}
int bitCount(uint word) {
  return std::popcount(word);
}
uint bitfieldExtract(uint word, int from, int count) {
  return count == 32 ? word : (word >> from) & ((1U << count) - 1U);
}
template <class T>
T texelFetch(const std::vector<T>& texels, int i) {
  return texels.at(static_cast<std::size_t>(i));
}

#define FUNCTION inline
#define precise
#define EXACT_PICTURE
#include "glsl/draw/overlay/pixel.glsl"

struct FieldModel : FieldInputs {
  static constexpr bool magnified = false;  // The value `false` selects the loops that kernels with the
                                            // define MAGNIFIED leave out.
  const std::vector<vec4>& reduced;

  [[nodiscard]] vec4 reducedAt(ivec2 at) const {
    return reduced.at(static_cast<std::size_t>(at.y * size.x + at.x));
  }
#include "glsl/draw/overlay/field_values.glsl"
// These files need field_values.glsl, which defines cells and colours.
#include "glsl/draw/overlay/field_means.glsl"
#include "glsl/draw/overlay/field_shading.glsl"
};

struct ChartModel : ChartInputs {
  const std::vector<std::array<vec4, 4>>& columns;

  [[nodiscard]] vec4 columnAt(int column, int row) const {
    return columns.at(static_cast<std::size_t>(column)).at(static_cast<std::size_t>(row));
  }
#include "glsl/draw/overlay/chart_columns.glsl"
// This file needs chart_columns.glsl, because the shading reads the column heights.
#include "glsl/draw/overlay/chart_shading.glsl"
};
#undef EXACT_PICTURE
#undef precise
#undef FUNCTION

/// Loads an 8-bit pixel, blends `pixel` over it and rounds the result to bytes, as image loads and stores
/// do.
OverlayBytes stored(OverlayBytes below, vec4 pixel) {
  vec4 loaded;
  for (int i = 0; i < 4; ++i)
    loaded[i] = static_cast<float>(below.at(static_cast<std::size_t>(i))) / 255.0F;
  const vec4 result = storedBytes(laidOver(bytesOf(loaded), pixel));
  OverlayBytes bytes{};
  for (int i = 0; i < 4; ++i)
    bytes.at(static_cast<std::size_t>(i)) = static_cast<std::uint8_t>(std::lround(result[i] * 255.0F));
  return bytes;
}

template <class T, class Change>
void eachPixel(OverlayPicture<T>& picture, ivec4 part, const Change& change) {
  for (int y = max(part.y, 0); y < min(part.w, picture.size.y); ++y)
    for (int x = max(part.x, 0); x < min(part.z, picture.size.x); ++x) change({x, y}, picture.at(x, y));
}

}  // namespace

}  // namespace simreel::shader

namespace shader = simreel::shader;

std::vector<glm::vec4> FieldTwin::averaged(glm::ivec2 texels) const {
  shader::FieldModel model{inputs_, reduced_};
  std::vector<glm::vec4> result;
  for (int y = 0; y < texels.y; ++y)
    for (int x = 0; x < texels.x; ++x) result.push_back(model.texelMean({x, y}, texels));
  return result;
}

void FieldTwin::over(OverlayPicture<OverlayBytes>& picture, glm::ivec4 part) const {
  shader::FieldModel model{inputs_, reduced_};
  shader::eachPixel(picture, part, [&](glm::ivec2 at, OverlayBytes& pixel) {
    pixel = shader::stored(pixel, model.fieldPixel(at));
  });
}

void FieldTwin::behind(OverlayPicture<glm::vec4>& light, glm::ivec4 part) const {
  shader::FieldModel model{inputs_, reduced_};
  shader::eachPixel(light, part, [&](glm::ivec2 at, glm::vec4& pixel) {
    pixel = shader::laidBehind(pixel, model.fieldPixel(at));
  });
}

ChartTwin::ChartTwin(ChartInputs inputs) : inputs_(std::move(inputs)) {
  for (glm::vec3& color : inputs_.colors) color = shader::encoded(glm::clamp(color, 0.0F, 1.0F));
  if (inputs_.steps < 1) return;
  shader::ChartModel model{inputs_, columns_};
  const int count = static_cast<int>(inputs_.plot.z - inputs_.plot.x);
  for (int i = 0; i < count; ++i) {
    const auto column = model.columnOf(i, inputs_.perColumn);
    columns_.push_back({column.enter, column.leave, column.lowest, column.highest});
  }
}

void ChartTwin::over(OverlayPicture<OverlayBytes>& picture, glm::ivec4 part) const {
  shader::ChartModel model{inputs_, columns_};
  shader::eachPixel(picture, part, [&](glm::ivec2 at, OverlayBytes& pixel) {
    pixel = shader::stored(pixel, model.chartPixel(glm::vec2(at) + 0.5F));
  });
}
