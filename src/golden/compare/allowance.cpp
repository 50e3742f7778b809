#include "golden/compare/allowance.hpp"

#include "base/error.hpp"
#include "golden/compare/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace simreel::golden {

namespace {

/// Pixel values of a picture, with the queries that excuses() needs.
class Values {
 public:
  Values(const std::vector<float>& values, int width, int height)
      : values_(values), width_(width), height_(height) {}

  [[nodiscard]] const float* at(int x, int y) const {
    return values_.data() + 4 * (std::size_t(y) * std::size_t(width_) + std::size_t(x));
  }
  /// Returns the Rec. 601 luma of the pixel blended over white, so that transparent pixels also have a
  /// brightness.
  [[nodiscard]] float brightness(int x, int y) const {
    const float* p = at(x, y);
    const float luma = 0.299F * p[0] + 0.587F * p[1] + 0.114F * p[2];
    return 255 + (luma - 255) * (p[3] / 255);
  }
  /// Calls visit(x, y) for all pixels of the picture within `radius`, including the centre.
  template <class Visit>
  void around(int x, int y, int radius, const Visit& visit) const {
    for (int v = std::max(0, y - radius); v <= std::min(height_ - 1, y + radius); ++v)
      for (int u = std::max(0, x - radius); u <= std::min(width_ - 1, x + radius); ++u) visit(u, v);
  }
  /// True if more than two neighbours have exactly the pixel's colour. If the pixel is at the picture's
  /// border, the border counts as one such neighbour.
  [[nodiscard]] bool inEvenPatch(int x, int y) const {
    int same = atBorder(x, y) ? 1 : 0;
    const float* middle = at(x, y);
    around(x, y, 1, [&](int u, int v) {
      if ((u != x || v != y) && std::equal(middle, middle + 4, at(u, v))) ++same;
    });
    return same > 2;
  }
  [[nodiscard]] bool atBorder(int x, int y) const {
    return x == 0 || y == 0 || x == width_ - 1 || y == height_ - 1;
  }
  /// True if a pixel within `radius` has this colour; each channel may differ by at most `difference`.
  [[nodiscard]] bool has(const float* colour, int x, int y, int radius, double difference) const {
    bool found = false;
    around(x, y, radius, [&](int u, int v) {
      const float* p = at(u, v);
      bool near = true;
      for (int c = 0; c < 4; ++c) near = near && std::abs(double{p[c]} - double{colour[c]}) <= difference;
      found = found || near;
    });
    return found;
  }

 private:
  const std::vector<float>& values_;
  int width_, height_;
};

/// True if the pixel of `one` is on an antialiased edge, and `other` has the same edge.
bool smooths(const Values& one, const Values& other, int x, int y) {
  const float middle = one.brightness(x, y);
  float darkest = 0, brightest = 0;
  int darkX = x, darkY = y, brightX = x, brightY = y;
  int same = one.atBorder(x, y) ? 1 : 0;
  one.around(x, y, 1, [&](int u, int v) {
    if (u == x && v == y) return;
    const float step = one.brightness(u, v) - middle;
    if (step == 0) ++same;
    if (step < darkest) darkest = step, darkX = u, darkY = v;
    if (step > brightest) brightest = step, brightX = u, brightY = v;
  });
  if (same > 2 || darkest == 0 || brightest == 0) return false;
  const auto even = [&](int u, int v) { return one.inEvenPatch(u, v) && other.inEvenPatch(u, v); };
  return even(darkX, darkY) || even(brightX, brightY);
}

}  // namespace

std::vector<Excuse> excuses(const std::vector<float>& a, const std::vector<float>& b, int width, int height,
                            const Allowance& allowance, double maxChannelDiff) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  SIMREEL_CHECK_EQ(a.size(), 4 * pixels);
  SIMREEL_CHECK_EQ(b.size(), 4 * pixels);
  if (!allowance.mask.empty()) SIMREEL_CHECK_EQ(allowance.mask.size(), pixels);
  std::vector<Excuse> found(pixels, Excuse::none);
  const Values first(a, width, height), second(b, width, height);
  const auto excuseOf = [&](int x, int y, std::size_t pixel) {
    if (!allowance.mask.empty() && allowance.mask[pixel] != 0) return Excuse::masked;
    const float *p = first.at(x, y), *q = second.at(x, y);
    if (std::equal(p, p + 4, q)) return Excuse::none;
    if (allowance.ignoreAntialiased && (smooths(first, second, x, y) || smooths(second, first, x, y)))
      return Excuse::antialiased;
    const int radius = allowance.searchRadius;
    if (radius > 0 && first.has(q, x, y, radius, maxChannelDiff) &&
        second.has(p, x, y, radius, maxChannelDiff))
      return Excuse::moved;
    return Excuse::none;
  };
  forEachBand(height, [&](int top, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = 0; x < width; ++x) {
        const std::size_t pixel = std::size_t(y) * std::size_t(width) + std::size_t(x);
        found[pixel] = excuseOf(x, y, pixel);
      }
  });
  return found;
}

}  // namespace simreel::golden
