#include "golden/compare/comparison.hpp"

#include "base/error.hpp"
#include "golden/compare/difference_image.hpp"
#include "golden/compare/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <fmt/ranges.h>

namespace simreel::golden {

namespace {

/// Two differing layers of the same name.
struct LayerPair {
  const PictureLayer *a, *b;
};

const PictureLayer* layerOf(const Picture& picture, const std::string& name) {
  const auto found = std::find_if(picture.layers.begin(), picture.layers.end(),
                                  [&](const PictureLayer& layer) { return layer.name == name; });
  return found == picture.layers.end() ? nullptr : &*found;
}

std::vector<std::string> layersOnlyIn(const Picture& one, const Picture& other) {
  std::vector<std::string> names;
  for (const PictureLayer& layer : one.layers)
    if (layerOf(other, layer.name) == nullptr) names.push_back(layer.name);
  return names;
}

/// Returns the pairs of layers that differ. Writes differences that no tolerance permits to made.layers.
std::vector<LayerPair> pairLayers(const Picture& a, const Picture& b, Comparison& made) {
  std::vector<LayerPair> pairs;
  std::vector<std::string> clauses;
  if (!a.layered || !b.layered) {
    if (const auto names = a.layered ? layersOnlyIn(a, b) : layersOnlyIn(b, a); !names.empty())
      made.layerNote = fmt::format("not compared, because one of the files cannot have layers: {}",
                                   fmt::join(names, ", "));
    return pairs;
  }
  for (const auto& [names, side] :
       {std::pair(layersOnlyIn(a, b), "baseline"), std::pair(layersOnlyIn(b, a), "picture")})
    if (!names.empty()) clauses.push_back(fmt::format("only the {} has {}", side, fmt::join(names, ", ")));
  for (const PictureLayer& layer : a.layers) {
    const PictureLayer* other = layerOf(b, layer.name);
    if (other == nullptr || layer == *other) continue;
    if (layer.kind == PictureLayer::Kind::content || other->kind == PictureLayer::Kind::content)
      clauses.push_back(layer.name + " differs");
    else
      pairs.push_back({&layer, other});
  }
  made.layers = fmt::format("{}", fmt::join(clauses, "; "));
  return pairs;
}

/// Describes where each pair of layers differs.
std::string layerWords(const std::vector<LayerPair>& pairs, const std::vector<Excuse>& excuses, int width) {
  std::vector<std::string> clauses;
  for (const auto& [a, b] : pairs) {
    long count = 0;
    std::size_t at = 0;
    double worst = 0;
    for (std::size_t pixel = 0; pixel < a->bits.size(); ++pixel) {
      if (!excuses.empty() && excuses[pixel] != Excuse::none) continue;
      const double difference = a->difference(*b, pixel);
      count += difference > 0 ? 1 : 0;
      if (difference <= worst) continue;
      worst = difference;
      at = pixel;
    }
    if (count == 0) continue;
    const auto value = [at](const PictureLayer& layer) {
      return layer.kind == PictureLayer::Kind::number ? fmt::format("{:g}", layer.number(at))
                                                      : fmt::format("{:08x}", layer.bits[at]);
    };
    clauses.push_back(fmt::format("{} at {} pixel{} ({} and {} at x {}, y {})", a->name, count,
                                  count == 1 ? "" : "s", value(*a), value(*b), at % std::size_t(width),
                                  at / std::size_t(width)));
  }
  return clauses.empty() ? std::string() : fmt::format("layers that differ: {}", fmt::join(clauses, ", "));
}

/// Two pictures that are compared by float values, because at least one of them has more than 8 bits per
/// channel.
struct DeepPair {
  std::vector<float> a, b;
  bool sameDepth;
  const Picture &pictureA, &pictureB;
  std::vector<LayerPair> layers;

  /// Returns the largest channel difference in units of 1/255, at most 255. The result is above 0 whenever
  /// the files' numbers differ.
  [[nodiscard]] double difference(std::size_t pixel) const {
    double worst = 0;
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i) worst = std::max(worst, channelApart(i));
    for (const LayerPair& layer : layers) worst = std::max(worst, layer.a->difference(*layer.b, pixel));
    return worst;
  }

 private:
  [[nodiscard]] double channelApart(std::size_t i) const {
    if (sameDepth) {
      const float x = pictureA.values[i], y = pictureB.values[i];
      if (x == y || (std::isnan(x) && std::isnan(y))) return 0;
    }
    const double between = std::abs(double{a[i]} - double{b[i]});
    if (std::isnan(between)) return 255;  // one of the values is NaN
    // smallest reported difference; used for values closer than the sRGB encoding resolves
    constexpr double hair = 1e-6;
    return between == 0 ? (sameDepth ? hair : 0) : std::min(between, 255.0);
  }
};

/// Returns the PSNR over R, G and B of pictures with more than 8 bits per channel, whose small differences
/// are lost in 8 bits. Transparent pictures are measured over black and over white, and the worse result
/// counts.
double deepPsnr(const DeepPair& pair) {
  double worst = std::numeric_limits<double>::infinity();
  for (const double background : {0.0, 255.0}) {
    double squares = 0;
    const auto over = [&](const std::vector<float>& units, std::size_t pixel, std::size_t c) {
      const double alpha = double{units[4 * pixel + 3]} / 255;
      return double{units[4 * pixel + c]} * alpha + background * (1 - alpha);
    };
    const std::size_t pixels = pair.a.size() / 4;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
      for (std::size_t c = 0; c < 3; ++c) {
        const double difference = over(pair.a, pixel, c) - over(pair.b, pixel, c);
        squares += difference * difference;
      }
    if (squares > 0)
      worst = std::min(worst, 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(pixels) / squares));
  }
  return worst;
}

void padToEach(Picture& a, Picture& b) {
  const int width = std::max(a.image.width, b.image.width);
  const int height = std::max(a.image.height, b.image.height);
  for (Picture* one : {&a, &b})
    if (one->image.width != width || one->image.height != height) *one = padded(*one, width, height);
}

bool equalPixels(const Picture& a, const Picture& b) {
  if (a.depth != b.depth) return false;
  if (a.depth == Depth::unorm8) return a.image.bytes == b.image.bytes;
  // two NaNs count as equal
  return std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(),
                    [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Copies the ignored pixels of `a` into `b`, so that they count as equal, and counts them.
void excuse(const Picture& a, Picture& b, Comparison& made) {
  for (std::size_t pixel = 0; pixel < made.excuses.size(); ++pixel) {
    const Excuse why = made.excuses[pixel];
    if (why == Excuse::none) continue;
    ++(why == Excuse::masked        ? made.metrics.maskedPixels
       : why == Excuse::antialiased ? made.metrics.antialiasedPixels
                                    : made.metrics.movedPixels);
    const auto at = static_cast<std::ptrdiff_t>(4 * pixel);
    std::copy_n(a.image.bytes.begin() + at, 4, b.image.bytes.begin() + at);
    if (!b.values.empty() && !a.values.empty())
      std::copy_n(a.values.begin() + at, 4, b.values.begin() + at);
  }
}

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double t) {
  return static_cast<std::uint8_t>(std::lround(from + t * (to - from)));
}

}  // namespace

Comparison compare(const Picture& baseline, const Picture& picture, const scene::Tolerance& tolerance,
                   const Allowance& allowance, Measures measures) {
  Comparison made;
  Picture a = baseline, b = picture;
  const frame::Image &sizeA = baseline.image, &sizeB = picture.image;
  if (sizeA.width != sizeB.width || sizeA.height != sizeB.height) {
    made.sizes = fmt::format("the picture is {}x{}, its baseline {}x{}", sizeB.width, sizeB.height,
                             sizeA.width, sizeA.height);
    padToEach(a, b);
  }
  if (a.colours != b.colours)
    made.colours =
        fmt::format("the colour spaces of the files differ, which is not compared: {}; {}",
                    a.colours.empty() ? "as usual" : a.colours, b.colours.empty() ? "as usual" : b.colours);
  const int width = a.image.width, height = a.image.height;
  if (!allowance.mask.empty() && allowance.mask.size() != std::size_t(width) * std::size_t(height))
    fail(ExitCode::usage, "the mask has {} pixels, the pictures that it masks {}x{}", allowance.mask.size(),
         width, height);
  const std::vector<LayerPair> layers = pairLayers(a, b, made);
  const bool deep = a.depth != Depth::unorm8 || b.depth != Depth::unorm8;
  if (!allowance.none() && (!equalPixels(a, b) || !allowance.mask.empty())) {
    made.excuses = excuses(inUnits(a), inUnits(b), width, height, allowance, tolerance.maxChannelDiff);
    excuse(a, b, made);
  }
  const Metrics counted = made.metrics;
  if (layers.empty() && equalPixels(a, b)) {
    made.metrics = measure(a.image, a.image, tolerance);
  } else if (!deep) {
    made.metrics = measure(a.image, b.image, tolerance, measures);
  } else {
    const DeepPair pair{inUnits(a), inUnits(b), a.depth == b.depth, a, b, layers};
    std::vector<float> difference(std::size_t(width) * std::size_t(height));
    made.difference.resize(difference.size());
    for (std::size_t pixel = 0; pixel < difference.size(); ++pixel) {
      const bool excused = !made.excuses.empty() && made.excuses[pixel] != Excuse::none;
      difference[pixel] = excused ? 0.0F : static_cast<float>(pair.difference(pixel));
      made.difference[pixel] = static_cast<std::uint8_t>(std::ceil(difference[pixel]));
    }
    made.metrics = measureDifferences(difference, a.image, b.image, tolerance, measures);
    if (a.depth != Depth::linear && b.depth != Depth::linear) made.metrics.psnr = deepPsnr(pair);
    if (!layers.empty()) made.layerNote = layerWords(layers, made.excuses, width);
  }
  made.metrics.maskedPixels = counted.maskedPixels;
  made.metrics.antialiasedPixels = counted.antialiasedPixels;
  made.metrics.movedPixels = counted.movedPixels;
  made.a = std::move(a.image);
  made.b = std::move(b.image);
  return made;
}

frame::Image differenceImage(const Comparison& comparison) {
  frame::Image image = comparison.difference.empty() ? differenceImage(comparison.a, comparison.b)
                                                     : differenceImage(comparison.a, comparison.difference);
  constexpr std::array<std::array<std::uint8_t, 3>, 4> tints = {
      {{0, 0, 0}, {70, 30, 110}, {190, 190, 200}, {120, 80, 50}}};
  for (std::size_t pixel = 0; pixel < comparison.excuses.size(); ++pixel) {
    if (comparison.excuses[pixel] == Excuse::none) continue;
    const auto& tint = tints[static_cast<std::size_t>(comparison.excuses[pixel])];
    for (std::size_t c = 0; c < 3; ++c)
      image.bytes[4 * pixel + c] = mixed(image.bytes[4 * pixel + c], tint[c], 0.75);
  }
  return image;
}

frame::Image flipImage(const Comparison& comparison) {
  constexpr std::array<std::array<std::uint8_t, 3>, 5> stops = {
      {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}}};
  const std::vector<float> map = flipMap(comparison.a, comparison.b);
  frame::Image image{comparison.a.width, comparison.a.height,
                     std::vector<std::uint8_t>(comparison.a.bytes.size(), 255)};
  for (std::size_t pixel = 0; pixel < map.size(); ++pixel) {
    const double at = std::clamp(double{map[pixel]}, 0.0, 1.0) * (stops.size() - 1);
    const std::size_t stop = std::min(stops.size() - 2, static_cast<std::size_t>(at));
    for (std::size_t c = 0; c < 3; ++c)
      image.bytes[4 * pixel + c] = mixed(stops[stop][c], stops[stop + 1][c], at - double(stop));
  }
  return image;
}

}  // namespace simreel::golden
