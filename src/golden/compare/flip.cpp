#include "golden/compare/flip.hpp"

#include "base/error.hpp"
#include "golden/compare/bands.hpp"
#include "golden/compare/filter.hpp"
#include "golden/compare/flip_colour.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace simreel::golden {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double pixelsPerDegree = 3840 * pi / 180;  // 0.7 m * (3840 / 0.7 m) * pi / 180

/// All filters of the paper, as one-dimensional halves: Gaussians and their derivatives separate.
struct Filters {
  /// Contrast sensitivity (section 4.1.1): sums of Gaussians a sqrt(pi / b) exp(-pi^2 d^2 / b), d in
  /// degrees.
  HalfKernel achromatic, redGreen, blueYellow1, blueYellow2;
  float share1 = 0, share2 = 0;  ///< of the two Gaussians of blue-yellow
  /// Feature detectors (section 4.2.1): a Gaussian, its first and its second derivative.
  HalfKernel smooth, edge, point;
  int radius = 0;  ///< of the widest
};

/// exp(-pi^2 d^2 / b) with d = x / ppd is a Gaussian of this sigma, in pixels.
double contrastSigma(double b) {
  return std::sqrt(b / (2 * pi * pi)) * pixelsPerDegree;
}

/// Sum over the square of (2 radius + 1)^2 pixels of a sqrt(pi / b) exp(...).
double contrastWeight(double a, double b, int radius) {
  double line = 1;
  const double sigma = contrastSigma(b);
  for (int x = 1; x <= radius; ++x) line += 2 * std::exp(-x * x / (2 * sigma * sigma));
  return a * std::sqrt(pi / b) * line * line;
}

/// Weights at x > 0 of -x g(x), or of (x^2 / sd^2 - 1) g(x). Positive weights are scaled to sum to 1 and
/// negative ones to -1, over the whole kernel.
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
  const int contrastRadius = static_cast<int>(std::ceil(3 * contrastSigma(blueYellow1)));
  f.achromatic = gaussianKernel(contrastSigma(achromatic), contrastRadius);
  f.redGreen = gaussianKernel(contrastSigma(redGreen), contrastRadius);
  f.blueYellow1 = gaussianKernel(contrastSigma(blueYellow1), contrastRadius);
  f.blueYellow2 = gaussianKernel(contrastSigma(blueYellow2), contrastRadius);
  const double weight1 = contrastWeight(34.1, blueYellow1, contrastRadius);
  const double weight2 = contrastWeight(13.5, blueYellow2, contrastRadius);
  f.share1 = static_cast<float>(weight1 / (weight1 + weight2));
  f.share2 = static_cast<float>(weight2 / (weight1 + weight2));
  // 0.082 degrees from peak to trough of the edge detector, which is two standard deviations.
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

/// One picture's band: opponent colours filtered along the rows, with `radius` more rows above and below.
struct Band {
  Band(const frame::Image& image, int first, int last);
  Rows achromatic, redGreen, blueYellow1, blueYellow2, smooth, edge, point;
};

Band::Band(const frame::Image& image, int first, int last)
    : achromatic(last - first + 2 * filters().radius, image.width),
      redGreen(achromatic),
      blueYellow1(achromatic),
      blueYellow2(achromatic),
      smooth(achromatic),
      edge(achromatic),
      point(achromatic) {
  const Filters& f = filters();
  PaddedRow y(image.width, f.radius), cx(image.width, f.radius), cz(image.width, f.radius);
  for (int line = 0; line < last - first + 2 * f.radius; ++line) {
    const std::uint8_t* from = clampedRow(image, first - f.radius + line);
    for (int x = 0; x < image.width; ++x) {
      const Ycxcz colour = toYcxcz(linear(from[4 * x]), linear(from[4 * x + 1]), linear(from[4 * x + 2]));
      y.data()[x] = colour.y;
      cx.data()[x] = colour.cx;
      cz.data()[x] = colour.cz;
    }
    y.pad();
    cx.pad();
    cz.pad();
    filterEven(y.data(), image.width, f.achromatic, achromatic.row(line));
    filterEven(cx.data(), image.width, f.redGreen, redGreen.row(line));
    filterEven(cz.data(), image.width, f.blueYellow1, blueYellow1.row(line));
    filterEven(cz.data(), image.width, f.blueYellow2, blueYellow2.row(line));
    filterEven(y.data(), image.width, f.smooth, smooth.row(line));
    filterOdd(y.data(), image.width, f.edge, edge.row(line));
    filterBend(y.data(), image.width, f.point, point.row(line));
  }
}

/// One row, seen: colours after the eye's filter in Hunt-adjusted L*a*b*, and the strength of its features.
struct SeenRow {
  explicit SeenRow(int width) : values(7, width), colours(std::size_t(width)) {}
  void look(const Band& band, int middle, int width);

  Rows values;  ///< 0 to 2: Y, Cx, Cz; 3, 4: edges along x and y; 5, 6: points along x and y
  std::vector<HuntLab> colours;
};

void SeenRow::look(const Band& band, int middle, int width) {
  const Filters& f = filters();
  for (const int row : {0, 1, 2, 3, 5}) std::fill(values.row(row), values.row(row) + width, 0.0f);
  addEvenRows(band.achromatic, middle, width, f.achromatic, 1, values.row(0));
  addEvenRows(band.redGreen, middle, width, f.redGreen, 1, values.row(1));
  addEvenRows(band.blueYellow1, middle, width, f.blueYellow1, f.share1, values.row(2));
  addEvenRows(band.blueYellow2, middle, width, f.blueYellow2, f.share2, values.row(2));
  addEvenRows(band.edge, middle, width, f.smooth, 1, values.row(3));
  filterOddRows(band.smooth, middle, width, f.edge, values.row(4));
  addEvenRows(band.point, middle, width, f.smooth, 1, values.row(5));
  filterBendRows(band.smooth, middle, width, f.point, values.row(6));
  for (int x = 0; x < width; ++x)
    colours[std::size_t(x)] =
        toHuntLab(clampedLinearRgb({values.row(0)[x], values.row(1)[x], values.row(2)[x]}));
}

float length(const Rows& rows, int row, int x) {
  const float along = rows.row(row)[x], down = rows.row(row + 1)[x];
  return std::sqrt(along * along + down * down);
}

/// Difference of the lengths of two gradients. Detectors ran on Y = 116 y; dividing makes them those of y.
float featureDifference(const Rows& a, const Rows& b, int row, int x) {
  return std::abs(length(a, row, x) - length(b, row, x)) / 116;
}

void combine(const SeenRow& a, const SeenRow& b, int width, float* errors) {
  for (int x = 0; x < width; ++x) {
    const float colour = colourError(a.colours[std::size_t(x)], b.colours[std::size_t(x)]);
    const float feature =
        std::max(featureDifference(a.values, b.values, 3, x), featureDifference(a.values, b.values, 5, x));
    // Equation: dE = dEc^(1 - dEf), dEf = (feature / sqrt(2))^0.5.
    const float exponent = 1 - std::sqrt(feature * (1 / std::numbers::sqrt2_v<float>));
    errors[x] = colour > 0 ? std::pow(colour, exponent) : 0;
  }
}

}  // namespace

std::vector<float> flipMap(const frame::Image& a, const frame::Image& b) {
  SIMREEL_CHECK_EQ(a.width, b.width);
  SIMREEL_CHECK_EQ(a.height, b.height);
  const int width = a.width, radius = filters().radius;
  std::vector<float> errors(std::size_t(width) * std::size_t(a.height), 0.0f);
  forEachBand(a.height, [&](int first, int last) {
    if (equalRows(a, b, first, last, radius)) return;
    const Band bandA(a, first, last), bandB(b, first, last);
    SeenRow seenA(width), seenB(width);
    for (int y = first; y < last; ++y) {
      seenA.look(bandA, y - first + radius, width);
      seenB.look(bandB, y - first + radius, width);
      combine(seenA, seenB, width, errors.data() + std::size_t(y) * std::size_t(width));
    }
  });
  return errors;
}

double flipMean(const frame::Image& a, const frame::Image& b) {
  const std::vector<float> errors = flipMap(a, b);
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

}  // namespace simreel::golden
