#include "sim/lenia/plan.hpp"

#include "base/ieee.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::sim {

namespace {

/// Returns a kernel's height at `r`, a fraction of its radius. The kernel consists of rings of the given
/// heights, each with the profile of the core.
double kernelHeight(const LeniaKernel& kernel, double r) {
  if (r >= 1) return 0;
  const auto rings = static_cast<double>(kernel.rings.size());
  const double at = r * rings;
  const auto ring = static_cast<std::size_t>(at);
  const double within = at - std::floor(at);
  const double q = within * (1 - within);
  if (q <= 0) return 0;
  const double square = 16 * q * q;
  const double core = kernel.core == LeniaKernel::Core::polynomial ? square * square : ieee::exp(4 - 1 / q);
  return kernel.rings[ring] / 100.0 * core;
}

/// Returns the fraction of a cell at the distance `d` that is inside a radius, approximated by a ramp that
/// is one cell wide.
double within(double d, double radius) {
  return std::clamp(radius + 0.5 - d, 0.0, 1.0);
}

int wrap(int x, int size) {
  return (x % size + size) % size;
}

}  // namespace

LeniaPlan::LeniaPlan(LeniaParameters parameters, const std::string& object, int seed, double frameSeconds)
    : parameters_(std::move(parameters)), seed_(seed), frameSeconds_(frameSeconds) {
  makeWeights();
  strokes_ = Strokes(parameters_.strokes, seed, {parameters_.size, true, "lenia \"" + object + "\""});
}

int LeniaPlan::kernels() const {
  return static_cast<int>(weights_.size());
}

void LeniaPlan::makeWeights() {
  const bool smooth = parameters_.model == LeniaParameters::Model::smoothLife;
  double maximum = smooth ? parameters_.radius + 0.5 : 0;
  if (!smooth)
    for (const LeniaKernel& kernel : parameters_.kernels) maximum = std::max(maximum, kernel.radius);
  range_ = static_cast<int>(std::ceil(maximum));
  const std::size_t count = smooth ? 2 : parameters_.kernels.size();
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> all;
    double sum = 0;
    for (int dy = -range_; dy <= range_; ++dy)
      for (int dx = -range_; dx <= range_; ++dx) {
        const double d = std::sqrt(static_cast<double>(dx * dx + dy * dy));
        const double inner = within(d, parameters_.radius / 3);
        const double w = !smooth  ? kernelHeight(parameters_.kernels[k], d / parameters_.kernels[k].radius)
                         : k == 0 ? within(d, parameters_.radius) - inner
                                  : inner;
        all.push_back(w);
        sum += w;
      }
    for (double& w : all) w /= sum;
    weights_.push_back(std::move(all));
  }
}

int LeniaPlan::reach(int dy) const {
  const int side = 2 * range_ + 1;
  const auto row = static_cast<std::size_t>(dy + range_) * static_cast<std::size_t>(side);
  for (int dx = range_; dx > 0; --dx)
    for (const auto& all : weights_)
      if (static_cast<float>(all[row + static_cast<std::size_t>(dx + range_)]) != 0) return dx;
  return 0;
}

float LeniaPlan::weight(int k, int dx, int dy) const {
  if (std::abs(dx) > range_ || std::abs(dy) > range_) return 0;
  const int at = (dy + range_) * (2 * range_ + 1) + dx + range_;
  return static_cast<float>(weights_[static_cast<std::size_t>(k)][static_cast<std::size_t>(at)]);
}

std::vector<glm::vec4> LeniaPlan::weights() const {
  std::vector<glm::vec4> result;
  for (int k = 0; k < kernels(); ++k)
    for (int dy = -range_; dy <= range_; ++dy)
      for (int dx = -range_; dx <= range_ + 3; ++dx)
        result.emplace_back(weight(k, dx, dy), weight(k, dx - 1, dy), weight(k, dx - 2, dy),
                            weight(k, dx - 3, dy));
  return result;
}

glm::vec4 LeniaPlan::growth(int k) const {
  if (parameters_.model == LeniaParameters::Model::smoothLife) return glm::vec4(0);
  const LeniaKernel& kernel = parameters_.kernels[static_cast<std::size_t>(k)];
  const double s2 = kernel.sigma * kernel.sigma;
  const double per = kernel.growth == LeniaKernel::Growth::polynomial ? 1 / (9 * s2)
                     : kernel.growth == LeniaKernel::Growth::gaussian ? 1 / (2 * s2)
                                                                      : kernel.sigma;
  return {kernel.mu, per, kernel.weight, static_cast<float>(kernel.growth)};
}

glm::vec4 LeniaPlan::limits() const {
  const LeniaParameters& p = parameters_;
  return {p.bornMin, p.bornMax, p.surviveMin, p.surviveMax};
}

glm::vec2 LeniaPlan::slopes() const {
  return {4 / parameters_.alphaRing, 4 / parameters_.alphaDisc};
}

std::vector<glm::vec4> LeniaPlan::firstCells() const {
  const glm::ivec2 size = parameters_.size;
  std::vector<glm::vec4> cells(static_cast<std::size_t>(rowItems()) * static_cast<std::size_t>(size.y),
                               glm::vec4(0));
  const auto at = [&](int x, int y) -> float& {
    x = wrap(x, size.x);
    return cells[static_cast<std::size_t>(wrap(y, size.y)) * static_cast<std::size_t>(rowItems()) +
                 static_cast<std::size_t>(x / 4)][x % 4];
  };
  // Patches consist of squares of 3 x 3 cells with one value, so that kernels do not average the values
  // away.
  constexpr int grain = 3;
  for (int i = 0; i < parameters_.patches; ++i) {
    const glm::uvec3 hash = shader::hash3(glm::uvec3(i, 0x1e41aU, seed_));
    const int left = static_cast<int>(hash.x % static_cast<unsigned>(size.x));
    const int top = static_cast<int>(hash.y % static_cast<unsigned>(size.y));
    const int side = range_ + static_cast<int>(hash.z % static_cast<unsigned>(range_ + 1));
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const unsigned value =
            shader::hash3(glm::uvec3(x / grain, y / grain, static_cast<unsigned>(seed_) + 977U * hash.z))
                .x >>
            8U;
        at(left + x, top + y) = static_cast<float>(value) / 16777216.0F;
      }
  }
  for (const LeniaCreature& creature : parameters_.creatures) {
    const LeniaShape& shape = leniaCreatures()[static_cast<std::size_t>(creature.kind)];
    const glm::ivec2 middle = creature.at.value_or(size / 2);
    const auto height = static_cast<int>(shape.rows.size());
    for (int y = 0; y < height; ++y) {
      const std::string_view row = shape.rows[static_cast<std::size_t>(y)];
      const auto width = static_cast<int>(row.size());
      for (int x = 0; x < width; ++x) {
        glm::ivec2 p(creature.mirrored ? width - 1 - x - width / 2 : x - width / 2, y - height / 2);
        for (int turn = 0; turn < creature.rotate / 90; ++turn) p = {-p.y, p.x};
        if (const float value = leniaDigit(row[static_cast<std::size_t>(x)]); value > 0)
          at(middle.x + p.x, middle.y + p.y) = value;
      }
    }
  }
  return cells;
}

long LeniaPlan::frameAt(double time) const {
  return std::lround(time / frameSeconds_);
}

long LeniaPlan::stepAt(long frame) const {
  const double steps = static_cast<double>(frame) * parameters_.stepsPerSecond * frameSeconds_;
  return static_cast<long>(std::floor(steps + 1e-9 * (1 + std::abs(steps))));
}

int LeniaPlan::stepsPerFrame() const {
  const double steps = parameters_.stepsPerSecond * frameSeconds_;
  return std::max(1, static_cast<int>(std::ceil(steps - 1e-9 * (1 + steps))));
}

std::vector<shader::Stroke> LeniaPlan::strokesInto(long step) const {
  if (strokes_.empty()) return {};
  const double seconds = 1 / parameters_.stepsPerSecond;
  return strokes_.into(static_cast<double>(step) * seconds, seconds, step);
}

}  // namespace simreel::sim
