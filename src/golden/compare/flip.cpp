#include "golden/compare/flip.hpp"

#include "base/error.hpp"
#include "golden/compare/filter.hpp"
#include "golden/compare/flip_colour.hpp"
#include "golden/compare/four.hpp"
#include "golden/compare/tiles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace simreel::golden {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double pixelsPerDegree = 3840 * pi / 180;  // 0.7 m * (3840 / 0.7 m) * pi / 180

/// All filters of the paper as one-dimensional half kernels. This is possible because Gaussians and their
/// derivatives are separable.
struct Filters {
  /// Contrast sensitivity filters (section 4.1.1). They are sums of Gaussians a sqrt(pi / b) exp(-pi^2 d^2
  /// / b), where d is the distance in degrees.
  HalfKernel achromatic, redGreen, blueYellow1, blueYellow2;
  float share1 = 0, share2 = 0;  ///< weights of the two Gaussians of the blue-yellow filter
  /// Feature detectors (section 4.2.1): a Gaussian and its first and second derivative.
  HalfKernel smooth, edge, point;
  int radius = 0;  ///< radius of the widest filter
};

/// Returns sigma (pixels) of the Gaussian exp(-pi^2 d^2 / b) with d = x / pixelsPerDegree.
double contrastSigma(double b) {
  return std::sqrt(b / (2 * pi * pi)) * pixelsPerDegree;
}

/// Returns the sum of a sqrt(pi / b) exp(-pi^2 d^2 / b) over the square of (2 radius + 1)^2 pixels.
double contrastWeight(double a, double b, int radius) {
  double line = 1;
  const double sigma = contrastSigma(b);
  for (int x = 1; x <= radius; ++x) line += 2 * std::exp(-x * x / (2 * sigma * sigma));
  return a * std::sqrt(pi / b) * line * line;
}

/// Returns a half kernel that detects edges or points. With a Gaussian g of standard deviation sd, it is -x
/// g(x) (first derivative), or (x^2 / sd^2 - 1) g(x) if `second` (second derivative). Over the whole
/// kernel, positive weights are scaled to sum to 1 and negative ones to -1.
HalfKernel detector(double sd, int radius, bool second) {
  std::vector<double> weights;
  double positive = 0, negative = 0;
  for (int x = -radius; x <= radius; ++x) {
    const double g = std::exp(-x * x / (2 * sd * sd));
    const double weight = second ? (x * x / (sd * sd) - 1) * g : -x * g;
    (weight > 0 ? positive : negative) += std::abs(weight);
    if (x >= 0) weights.push_back(weight);
  }
  HalfKernel kernel;
  for (const double weight : weights)
    kernel.push_back(static_cast<float>(weight / (weight > 0 ? positive : negative)));
  return kernel;
}

Filters makeFilters() {
  Filters f;
  const double achromatic = 0.0047, redGreen = 0.0053, blueYellow1 = 0.04, blueYellow2 = 0.025;
  constexpr double negligible = 1e-9;  // fraction of the centre weight; smaller weights have no effect in
                                       // float
  const int contrastRadius = static_cast<int>(std::ceil(3 * contrastSigma(blueYellow1)));
  f.achromatic = gaussianKernel(contrastSigma(achromatic), contrastRadius, negligible);
  f.redGreen = gaussianKernel(contrastSigma(redGreen), contrastRadius, negligible);
  f.blueYellow1 = gaussianKernel(contrastSigma(blueYellow1), contrastRadius);
  f.blueYellow2 = gaussianKernel(contrastSigma(blueYellow2), contrastRadius);
  const double weight1 = contrastWeight(34.1, blueYellow1, contrastRadius);
  const double weight2 = contrastWeight(13.5, blueYellow2, contrastRadius);
  f.share1 = static_cast<float>(weight1 / (weight1 + weight2));
  f.share2 = static_cast<float>(weight2 / (weight1 + weight2));
  // The distance from the peak to the trough of the edge detector is 0.082 degrees, which is two standard
  // deviations.
  const double sd = 0.5 * 0.082 * pixelsPerDegree;
  const int detectorRadius = static_cast<int>(std::ceil(3 * sd));
  f.smooth = gaussianKernel(sd, detectorRadius);
  f.edge = detector(sd, detectorRadius, false);
  f.point = detector(sd, detectorRadius, true);
  f.radius = std::max(contrastRadius, detectorRadius);
  return f;
}

const Filters& filters() {
  static const Filters all = makeFilters();
  return all;
}

/// A picture as the model of FLIP perceives it around one tile. It consists of contrast-filtered colours in
/// Hunt-adjusted L*a*b*, and feature strengths. Computes one row at a time: filters along the columns
/// first, then along the row.
class Seen {
 public:
  Seen(const frame::Image& image, const Tile& tile);
  /// Computes the perceived values of one row of the tile.
  void look(int row);
  [[nodiscard]] ThreeConstRows lab() const { return {made_.row(3), made_.row(4), made_.row(5)}; }
  /// Return the gradient magnitudes of the edge and point detectors, which are applied to the luminance Y =
  /// 116 y.
  [[nodiscard]] const float* edges() const { return made_.row(6); }
  [[nodiscard]] const float* points() const { return made_.row(7); }

 private:
  void convert(const frame::Image& image, const Tile& tile);

  int width_, wide_;  ///< width of the tile, and width including the filter radius on both sides
  Rows y_, cx_, cz_, down_, made_;
};

Seen::Seen(const frame::Image& image, const Tile& tile)
    : width_(tile.width),
      wide_(tile.width + 2 * filters().radius),
      y_(tile.height + 2 * filters().radius, wide_),
      cx_(y_),
      cz_(y_),
      down_(7, wide_),
      made_(10, wide_) {
  convert(image, tile);
}

/// Converts the pixels around the tile to YCxCz. Pixels outside of the picture repeat its border.
void Seen::convert(const frame::Image& image, const Tile& tile) {
  const int radius = filters().radius;
  Rows light(3, wide_);
  float *red = light.row(0), *green = light.row(1), *blue = light.row(2);
  std::vector<std::ptrdiff_t> columns;
  for (int x = tile.x - radius; x < tile.x + tile.width + radius; ++x)
    columns.push_back(std::ptrdiff_t{4} * std::clamp(x, 0, image.width - 1));
  for (int row = 0; row < tile.height + 2 * radius; ++row) {
    const int y = std::clamp(tile.y - radius + row, 0, image.height - 1);
    const std::uint8_t* from = image.bytes.data() + std::ptrdiff_t{4} * y * image.width;
    toLinear(from, columns.data(), wide_, {red, green, blue});
    toYcxcz({red, green, blue}, wide_, {y_.row(row), cx_.row(row), cz_.row(row)});
  }
}

void Seen::look(int row) {
  using enum Shape;
  const Filters& f = filters();
  const int middle = row + f.radius;
  const std::ptrdiff_t step = y_.stride();
  float *achromatic = down_.row(0), *smooth = down_.row(1), *edge = down_.row(2), *point = down_.row(3);
  float *redGreen = down_.row(4), *wide = down_.row(5), *narrow = down_.row(6);
  filterRow<even>(y_.row(middle), step, wide_, {{{&f.achromatic, achromatic}}});
  filterRow<even, odd, bend>(y_.row(middle), step, wide_,
                             {{{&f.smooth, smooth}, {&f.edge, edge}, {&f.point, point}}});
  filterRow<even>(cx_.row(middle), step, wide_, {{{&f.redGreen, redGreen}}});
  filterRow<even, even>(cz_.row(middle), step, wide_, {{{&f.blueYellow1, wide}, {&f.blueYellow2, narrow}}});

  float *y = made_.row(0), *cx = made_.row(1), *cz = made_.row(2);
  float *edges = made_.row(6), *points = made_.row(7), *across1 = made_.row(8), *across2 = made_.row(9);
  const auto along = [&](const float* in) { return in + f.radius; };
  filterRow<even>(along(achromatic), 1, width_, {{{&f.achromatic, y}}});
  filterRow<even>(along(redGreen), 1, width_, {{{&f.redGreen, cx}}});
  filterRow<even>(along(wide), 1, width_, {{{&f.blueYellow1, across1}}});
  filterRow<even>(along(narrow), 1, width_, {{{&f.blueYellow2, across2}}});
  for (int x = 0; x < width_; ++x) cz[x] = f.share1 * across1[x] + f.share2 * across2[x];
  toHuntLab({y, cx, cz}, width_, {made_.row(3), made_.row(4), made_.row(5)});

  filterRow<odd, bend>(along(smooth), 1, width_, {{{&f.edge, edges}, {&f.point, points}}});
  filterRow<even>(along(edge), 1, width_, {{{&f.smooth, across1}}});
  filterRow<even>(along(point), 1, width_, {{{&f.smooth, across2}}});
  const auto addSquares = [&](float* sum, const float* other) {
    for (int x = 0; x < width_; x += 4) {
      const Four one = load(sum + x), two = load(other + x);
      store(sum + x, squareRoot(one * one + two * two));
    }
  };
  addSquares(edges, across1);
  addSquares(points, across2);
}

/// Computes the FLIP errors of a row. The error is dEc^(1 - dEf) with the colour error dEc and dEf =
/// (feature / sqrt(2))^0.5. `feature` is the larger of two differences: of the edge magnitudes and of the
/// point magnitudes.
void combine(const Seen& a, const Seen& b, int width, float* errors) {
  colourErrors(a.lab(), b.lab(), width, errors);
  constexpr float scale = 1 / (116 * std::numbers::sqrt2_v<float>);
  for (int x = 0; x < width; x += 4) {
    const Four edge = magnitude(load(a.edges() + x) - load(b.edges() + x));
    const Four point = magnitude(load(a.points() + x) - load(b.points() + x));
    store(errors + x, powerOf(load(errors + x), 1 - squareRoot(larger(edge, point) * scale)));
  }
}

/// Calls use(tile, y, errors) for each picture row y of each tile in which the two pictures differ.
template <class Use>
void forEachErrorRow(const frame::Image& a, const frame::Image& b, const Use& use) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  forEachTile(a.width, a.height, [&](const Tile& tile) {
    if (equalAround(a, b, tile, filters().radius)) return;
    Seen seenA(a, tile), seenB(b, tile);
    Rows row(1, tile.width);
    float* errors = row.row(0);
    for (int y = 0; y < tile.height; ++y) {
      seenA.look(y);
      seenB.look(y);
      combine(seenA, seenB, tile.width, errors);
      use(tile, tile.y + y, errors);
    }
  });
}

}  // namespace

std::vector<float> flipMap(const frame::Image& a, const frame::Image& b) {
  std::vector<float> map(std::size_t(a.width) * std::size_t(a.height), 0.0f);
  forEachErrorRow(a, b, [&](const Tile& tile, int y, const float* errors) {
    std::copy_n(errors, tile.width, map.begin() + std::ptrdiff_t{y} * a.width + tile.x);
  });
  return map;
}

double flipMean(const frame::Image& a, const frame::Image& b) {
  std::vector<double> sums(std::size_t(tilesOver(a.width, a.height)), 0.0);
  forEachErrorRow(a, b, [&](const Tile& tile, int, const float* errors) {
    double& sum = sums[std::size_t(tile.index)];
    sum = std::accumulate(errors, errors + tile.width, sum);
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0) / (double(a.width) * a.height);
}

}  // namespace simreel::golden
