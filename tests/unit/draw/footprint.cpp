// Tests texture filtering over a pixel's footprint by comparison with an independent implementation in
// double precision.
#include "draw/picture_code.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <doctest/doctest.h>

namespace {

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names

#define FUNCTION
#define precise
struct TextureReads {
  std::vector<std::vector<float>> levels;
  glm::ivec2 size;
#include "glsl/draw/surface/footprint.glsl"
  [[nodiscard]] float texel(int x, int y, int level) const {
    const ivec2 side = max(size >> level, ivec2(1));
    REQUIRE(x >= 0);
    REQUIRE(y >= 0);
    REQUIRE(x < side.x);
    REQUIRE(y < side.y);
    return levels[static_cast<std::size_t>(level)][static_cast<std::size_t>(y * side.x + x)];
  }
  FILTERED(float, readAt, texel)
};
#undef precise
#undef FUNCTION

/// Returns the index of the texel that is read for an index outside the texture (OpenGL 4.5, table 8.20).
int wrappedTexel(double at, int count, int wrap) {
  if (wrap == WRAP_CLAMP) return static_cast<int>(std::clamp(at, 0.0, count - 1.0));
  if (wrap == WRAP_REPEAT) return static_cast<int>(at - count * std::floor(at / count));
  const double fromMiddle = at - 2 * count * std::floor(at / (2 * count)) - count;
  return static_cast<int>(count - 1 - (fromMiddle >= 0 ? fromMiddle : -1 - fromMiddle));
}

/// Interpolates between texel centres, which are at integers plus one half.
double between(const TextureReads& texture, double u, double v, int level, glm::ivec2 wrap) {
  const glm::ivec2 side = glm::max(texture.size >> level, glm::ivec2(1));
  const double x = u * side.x - 0.5;
  const double y = v * side.y - 0.5;
  double sum = 0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const double column = std::floor(x) + i;
      const double row = std::floor(y) + j;
      sum += (1 - std::abs(x - column)) * (1 - std::abs(y - row)) *
             static_cast<double>(texture.texel(wrappedTexel(column, side.x, wrap.x),
                                               wrappedTexel(row, side.y, wrap.y), level));
    }
  return sum;
}

/// Filters trilinearly, with taps along the longer side of the footprint. The filter width is the shorter
/// side, but at least a quarter of the longer side.
double seen(const TextureReads& texture, glm::dvec2 at, glm::dvec2 across, glm::dvec2 up, glm::ivec2 wrap) {
  const auto texels = [&](glm::dvec2 d) { return std::hypot(d.x * texture.size.x, d.y * texture.size.y); };
  const bool wide = texels(across) >= texels(up);
  const double longer = std::max(texels(across), texels(up));
  const double shorter = std::min(texels(across), texels(up));
  const double width = std::max({longer / 4, shorter, 1.0});
  const int last = static_cast<int>(texture.levels.size()) - 1;
  const int whole = static_cast<int>(std::floor(std::log2(width)));
  const int level = std::min(whole, last);
  const double part = whole >= last ? 0.0 : width / std::exp2(whole) - 1;
  const int taps = std::clamp(static_cast<int>(longer / width + 0.99), 1, 4);
  double sum = 0;
  for (int i = 0; i < taps; ++i) {
    const glm::dvec2 place = at + (wide ? across : up) * ((i + 0.5) / taps - 0.5);
    const double fine = between(texture, place.x, place.y, level, wrap);
    const double coarse = between(texture, place.x, place.y, std::min(level + 1, last), wrap);
    sum += fine + (coarse - fine) * part;
  }
  return sum / taps;
}

TextureReads noiseOf(glm::ivec2 size) {
  TextureReads texture{{}, size};
  std::mt19937 random(3);
  for (int level = 0;; ++level) {
    const glm::ivec2 side = glm::max(size >> level, glm::ivec2(1));
    texture.levels.emplace_back();
    for (int i = 0; i < side.x * side.y; ++i)
      texture.levels.back().push_back(static_cast<float>(random() >> 8U) * 0x1p-24F);
    if (side == glm::ivec2(1)) return texture;
  }
}

}  // namespace

TEST_CASE("footprints: texels, mip levels and taps equal double precision") {
  for (const glm::ivec2 size :
       {glm::ivec2(37, 21), glm::ivec2(64, 5), glm::ivec2(1, 9), glm::ivec2(1, 1)}) {
    TextureReads texture = noiseOf(size);
    std::mt19937 random(7);
    const auto number = [&](double maximum) {
      return (static_cast<double>(random()) * 0x1p-31 - 1) * maximum;
    };
    int far = 0;
    int levels = 0;
    int several = 0;
    for (int i = 0; i < 20000; ++i) {
      const double reach = std::exp2(number(6) - 4);
      const TextureReads::Seen at = {glm::vec2(number(2), number(2)),
                                     glm::vec2(number(reach), number(reach)),
                                     glm::vec2(number(reach), number(reach))};
      const glm::ivec2 wrap(i % 3, i / 3 % 3);
      const TextureReads::TextureShape shape = {size, static_cast<int>(texture.levels.size()), wrap};
      const auto print = texture.footprintOf(at, shape);
      levels += print.level > 0 ? 1 : 0;
      several += print.taps > 1 ? 1 : 0;
      const auto found = static_cast<double>(texture.readAt(at.at, print, shape));
      const double wanted = seen(texture, at.at, at.across, at.up, wrap);
      // In rare cases, a rounding error changes the number of taps.
      far += std::abs(found - wanted) > 2e-4 ? 1 : 0;
    }
    CAPTURE(size.x);
    CHECK(far <= 3);
    CHECK(several > 2000);
    if (size.x > 1) CHECK(levels > 1000);
  }
}
