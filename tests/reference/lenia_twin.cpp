#include "reference/lenia_twin.hpp"

#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace simreel::sim;

namespace {

namespace continuous {
using namespace simreel::shader;
using glm::vec4;
#define FUNCTION inline
#define precise
#include "glsl/lenia/model.glsl"
#undef precise
#undef FUNCTION
}  // namespace continuous

}  // namespace

LeniaTwin::LeniaTwin(LeniaPlan plan) : cells(plan.firstCells()), plan_(std::move(plan)) {}

void LeniaTwin::step() {
  const LeniaParameters& p = plan_.parameters();
  const glm::ivec2 size = p.size;
  const int range = plan_.range();
  const auto at = [&](int x, int y) {
    x = (x % size.x + size.x) % size.x;
    y = (y % size.y + size.y) % size.y;
    return cells[static_cast<std::size_t>(y * plan_.rowItems() + x / 4)][x % 4];
  };
  std::vector<glm::vec4> next(cells.size(), glm::vec4(0));
  std::vector<float> sums(static_cast<std::size_t>(plan_.kernels()));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      std::fill(sums.begin(), sums.end(), 0.0F);
      for (int dy = -range; dy <= range; ++dy)
        for (int dx = -plan_.reach(dy); dx <= plan_.reach(dy); ++dx)
          for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] = sums[k] + plan_.weight(static_cast<int>(k), dx, dy) * at(x + dx, y + dy);
      float change = 0;
      if (p.model == LeniaParameters::Model::smoothLife) {
        const glm::vec2 slopes = plan_.slopes();
        change =
            2.0F * continuous::smoothLifeNext(sums[0], sums[1], plan_.limits(), slopes.x, slopes.y) - 1.0F;
      } else {
        for (std::size_t k = 0; k < sums.size(); ++k) {
          const glm::vec4 g = plan_.growth(static_cast<int>(k));
          const float grown = continuous::leniaGrowth({g.x, g.y, g.z, static_cast<int>(g.w)}, sums[k]);
          change = change + g.z * grown;
        }
      }
      next[static_cast<std::size_t>(y * plan_.rowItems() + x / 4)][x % 4] =
          continuous::leniaHeld(at(x, y) + plan_.dt() * change);
    }
  cells = std::move(next);
}

LeniaInDouble::LeniaInDouble(const LeniaPlan& plan) : size_(plan.parameters().size), p_(plan.parameters()) {
  const auto first = plan.firstCells();
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x)
      cells.push_back(
          static_cast<double>(first[static_cast<std::size_t>(y * plan.rowItems() + x / 4)][x % 4]));
  // Computes the kernels from their definition. They are normalized rings of (4 r (1 - r))^4 or exp(4 - 1 /
  // (r (1 - r))), where r is the fraction of the ring's width.
  for (const LeniaKernel& kernel : p_.kernels)
    range_ = std::max(range_, static_cast<int>(std::ceil(kernel.radius)));
  for (const LeniaKernel& kernel : p_.kernels) {
    std::vector<double> all;
    double sum = 0;
    for (int dy = -range_; dy <= range_; ++dy)
      for (int dx = -range_; dx <= range_; ++dx) {
        const double rings = static_cast<double>(kernel.rings.size());
        const double r = std::hypot(dx, dy) / kernel.radius * rings;
        double w = 0;
        if (r < rings) {
          const double part = r - std::floor(r);
          const double core = kernel.core == LeniaKernel::Core::polynomial
                                  ? std::pow(4 * part * (1 - part), 4)
                                  : (part > 0 ? std::exp(4 - 1 / (part * (1 - part))) : 0);
          w = core * kernel.rings[static_cast<std::size_t>(r)] / 100;
        }
        all.push_back(w);
        sum += w;
      }
    for (double& w : all) w /= sum;
    weights_.push_back(std::move(all));
  }
}

double LeniaInDouble::growth(std::size_t k, double u) const {
  const LeniaKernel& kernel = p_.kernels[k];
  const double d = (u - kernel.mu) / kernel.sigma;
  if (kernel.growth == LeniaKernel::Growth::gaussian) return 2 * std::exp(-d * d / 2) - 1;
  if (kernel.growth == LeniaKernel::Growth::step) return std::abs(d) <= 1 ? 1 : -1;
  return 2 * std::pow(std::max(0.0, 1 - d * d / 9), 4) - 1;
}

void LeniaInDouble::step() {
  std::vector<double> next(cells.size());
  const int side = 2 * range_ + 1;
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      double change = 0;
      for (std::size_t k = 0; k < weights_.size(); ++k) {
        double u = 0;
        for (int i = 0; i < side * side; ++i) {
          if (weights_[k][static_cast<std::size_t>(i)] == 0) continue;
          const int sx = ((x + i % side - range_) % size_.x + size_.x) % size_.x;
          const int sy = ((y + i / side - range_) % size_.y + size_.y) % size_.y;
          u +=
              weights_[k][static_cast<std::size_t>(i)] * cells[static_cast<std::size_t>(sy * size_.x + sx)];
        }
        change += p_.kernels[k].weight * growth(k, u);
      }
      const std::size_t at = static_cast<std::size_t>(y * size_.x + x);
      next[at] = std::clamp(cells[at] + change / p_.timeScale, 0.0, 1.0);
    }
  cells = std::move(next);
}

SmoothLifeInDouble::SmoothLifeInDouble(const LeniaPlan& plan)
    : size_(plan.parameters().size), p_(plan.parameters()) {
  const auto first = plan.firstCells();
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x)
      cells.push_back(
          static_cast<double>(first[static_cast<std::size_t>(y * plan.rowItems() + x / 4)][x % 4]));
}

double SmoothLifeInDouble::at(int x, int y) const {
  x = (x % size_.x + size_.x) % size_.x;
  y = (y % size_.y + size_.y) % size_.y;
  return cells[static_cast<std::size_t>(y * size_.x + x)];
}

void SmoothLifeInDouble::step() {
  // The edge of a disc is a linear ramp that is one cell wide. Half of it is outside the disc.
  const auto disc = [](double d, double radius) {
    return d < radius - 0.5 ? 1.0 : d > radius + 0.5 ? 0.0 : radius + 0.5 - d;
  };
  const auto sigma1 = [](double x, double a, double alpha) {
    return 1 / (1 + std::exp(-(x - a) * 4 / alpha));
  };
  const int range = static_cast<int>(std::ceil(p_.radius)) + 1;
  std::vector<double> next(cells.size());
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      double inner = 0, innerArea = 0, outer = 0, outerArea = 0;
      for (int dy = -range; dy <= range; ++dy)
        for (int dx = -range; dx <= range; ++dx) {
          const double d = std::hypot(dx, dy), in = disc(d, p_.radius / 3), all = disc(d, p_.radius);
          inner += in * at(x + dx, y + dy);
          innerArea += in;
          outer += (all - in) * at(x + dx, y + dy);
          outerArea += all - in;
        }
      const double m = inner / innerArea, n = outer / outerArea;
      const double alive = sigma1(m, 0.5, p_.alphaDisc);
      const double low = p_.bornMin * (1 - alive) + p_.surviveMin * alive;
      const double high = p_.bornMax * (1 - alive) + p_.surviveMax * alive;
      const double s = sigma1(n, low, p_.alphaRing) * (1 - sigma1(n, high, p_.alphaRing));
      next[static_cast<std::size_t>(y * size_.x + x)] =
          std::clamp(at(x, y) + (2 * s - 1) / p_.timeScale, 0.0, 1.0);
    }
  cells = std::move(next);
}
