#include "sim/gray_scott/plan.hpp"

#include "base/log.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace simreel::sim {

namespace {

constexpr int maxImageSide = 32768;

/// Packs a pair of numbers per cell in the kernels' layout: two cells per element.
std::vector<glm::vec4> inPairs(glm::ivec2 size, const std::function<glm::vec2(int, int)>& cell) {
  std::vector<glm::vec4> elements;
  elements.reserve(static_cast<std::size_t>((size.x + 1) / 2) * static_cast<std::size_t>(size.y));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; x += 2)
      elements.emplace_back(cell(x, y), cell(x + 1 < size.x ? x + 1 : 0, y));
  return elements;
}

std::vector<float> barycentricWeights(const std::filesystem::path& file, const char* what,
                                      glm::ivec2 size) {
  const Picture picture = loadPicture(file, what, maxImageSide);
  std::vector<float> fractions;
  for (const std::uint8_t level : levelsOnGrid(picture, size))
    fractions.push_back(static_cast<float>(level) / 255.0F);
  return fractions;
}

}  // namespace

GrayScottPlan::GrayScottPlan(GrayScottParameters parameters, const std::string& object, int seed,
                             double frameSeconds)
    : parameters_(std::move(parameters)),
      seed_(seed),
      frameSeconds_(frameSeconds),
      strokes_(parameters_.strokes, seed, {parameters_.size, true, "grayScott \"" + object + "\""}) {
  const GrayScottParameters& p = parameters_;
  if (p.preset == GrayScottPreset::spots && !p.feed && !p.kill && !p.health && !mapped())
    warn("the rates of the grayScott preset \"spots\" let every pattern die out; \"leopard\" grows spots");
}

void GrayScottPlan::checkPictures() const {
  const GrayScottParameters& p = parameters_;
  for (const auto& [file, what] :
       {std::pair(&p.image, "image of v"), std::pair(&p.feedImage, "image of feed rates"),
        std::pair(&p.killImage, "image of kill rates")})
    if (!file->empty()) static_cast<void>(loadPicture(*file, what, maxImageSide));
}

std::vector<float> GrayScottPlan::firstV() const {
  const GrayScottParameters& p = parameters_;
  const auto cells = static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(p.size.y);
  std::vector<float> v(cells);
  if (!p.image.empty()) {
    v = barycentricWeights(p.image, "image of v", p.size);
    for (float& x : v) x *= static_cast<float>(p.seedValue);
  }
  const auto word = [&](unsigned i, unsigned purpose) {
    return shader::hash3({i, purpose, static_cast<unsigned>(seed_)});
  };
  const auto place = [](unsigned bits, int count) {
    return static_cast<int>(std::uint64_t{bits} * static_cast<std::uint64_t>(count) >> 32U);
  };
  const int reach = static_cast<int>(std::ceil(p.seedRadius));
  const glm::ivec2 span(std::min(reach, p.size.x / 2), std::min(reach, p.size.y / 2));
  for (int i = 0; i < p.seedCount; ++i) {
    const shader::uvec3 random = word(static_cast<unsigned>(i), 1);
    const glm::ivec2 middle(place(random.x, p.size.x), place(random.y, p.size.y));
    for (int dy = -span.y; dy <= span.y; ++dy)
      for (int dx = -span.x; dx <= span.x; ++dx) {
        if (dx * dx + dy * dy > p.seedRadius * p.seedRadius) continue;
        const int x = (middle.x + dx + p.size.x) % p.size.x;
        const int y = (middle.y + dy + p.size.y) % p.size.y;
        v[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.size.x) + static_cast<std::size_t>(x)] =
            static_cast<float>(p.seedValue);
      }
  }
  for (std::size_t i = 0; i < cells; ++i)
    if (v[i] > 0) {
      const float swing = shader::signedUnit(word(static_cast<unsigned>(i), 2).x);
      v[i] = std::min(v[i] * (1.0F + static_cast<float>(p.seedNoise) * swing), 1.0F);
    }
  return v;
}

std::vector<glm::vec4> GrayScottPlan::firstCells() const {
  const std::vector<float> v = firstV();
  const auto width = static_cast<std::size_t>(parameters_.size.x);
  return inPairs(parameters_.size, [&](int x, int y) {
    const float value = v[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    return glm::vec2(1.0F - value, value);
  });
}

bool GrayScottPlan::mapped() const {
  const GrayScottParameters& p = parameters_;
  return p.feedAcross || p.killDown || !p.feedImage.empty() || !p.killImage.empty();
}

std::vector<glm::vec4> GrayScottPlan::weights() const {
  if (!mapped()) return {};
  const GrayScottParameters& p = parameters_;
  std::vector<float> feed, kill;
  if (!p.feedImage.empty()) feed = barycentricWeights(p.feedImage, "image of feed rates", p.size);
  if (!p.killImage.empty()) kill = barycentricWeights(p.killImage, "image of kill rates", p.size);
  const auto width = static_cast<std::size_t>(p.size.x);
  return inPairs(p.size, [&](int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    const float across = static_cast<float>(x) / static_cast<float>(p.size.x - 1);
    const float down = static_cast<float>(y) / static_cast<float>(p.size.y - 1);
    return glm::vec2(feed.empty() ? across : feed[i], kill.empty() ? down : kill[i]);
  });
}

shader::GrayScottRates GrayScottPlan::ratesAt(double time) const {
  const GrayScottParameters& p = parameters_;
  const FeedKill now = p.ratesAt(time);
  const auto scaled = [&](double rate) { return static_cast<float>(rate * p.dt); };
  shader::GrayScottRates rates{};
  rates.diffuseU = scaled(p.diffuseU / 20);
  rates.diffuseV = scaled(p.diffuseV / 20);
  rates.feed = scaled(now.feed);
  rates.kill = scaled(now.kill);
  rates.dt = scaled(1);
  if (p.feedAcross) rates.feedSpan = scaled(*p.feedAcross - now.feed);
  if (p.killDown) rates.killSpan = scaled(*p.killDown - now.kill);
  if (!p.feedImage.empty()) rates.feedSpan = scaled(p.feedWhite - now.feed);
  if (!p.killImage.empty()) rates.killSpan = scaled(p.killWhite - now.kill);
  return rates;
}

void GrayScottPlan::retune(const GrayScottParameters& now) {
  parameters_.feed = now.feed;
  parameters_.kill = now.kill;
}

std::vector<shader::Stroke> GrayScottPlan::strokesAt(double time, int step) const {
  if (strokes_.empty()) return {};
  const double seconds = frameSeconds_ / parameters_.steps;
  const double now = time + step * seconds;
  return strokes_.into(now, seconds, std::lround(now / seconds));
}

}  // namespace simreel::sim
