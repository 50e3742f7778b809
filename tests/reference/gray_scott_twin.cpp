#include "reference/gray_scott_twin.hpp"

#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

using namespace simreel;

namespace {

void unpack(const std::vector<glm::vec4>& elements, glm::ivec2 size, std::vector<float>& first,
            std::vector<float>& second) {
  const int columns = (size.x + 1) / 2;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec4& pair = elements[static_cast<std::size_t>(y * columns + x / 2)];
      first.push_back(x % 2 == 0 ? pair.x : pair.z);
      second.push_back(x % 2 == 0 ? pair.y : pair.w);
    }
}

/// Three neighbouring rows of u or v.
struct Window {
  const float* above;
  const float* here;
  const float* below;

  [[nodiscard]] float laplacian(int left, int x, int right) const {
    const float edges = (here[left] + here[right]) + (above[x] + below[x]);
    const float corners = (above[left] + above[right]) + (below[left] + below[right]);
    return shader::laplacian20(here[x], edges, corners);
  }
};

}  // namespace

GrayScottTwin::GrayScottTwin(sim::GrayScottPlan plan, double start)
    : plan_(std::move(plan)), size_(plan_.parameters().size) {
  unpack(plan_.firstCells(), size_, u, v);
  if (plan_.mapped()) unpack(plan_.weights(), size_, feedWeights_, killWeights_);
  nextU_ = u;
  nextV_ = v;
  advance(plan_.ratesAt(0), plan_.parameters().presteps);
  for (const shader::Stroke& stroke : plan_.strokesAt(start, 0)) paint(stroke);
}

void GrayScottTwin::step(double time, int threads) {
  const auto rates = plan_.ratesAt(time);
  for (int i = 1; i <= plan_.parameters().steps; ++i) {
    advance(rates, 1, threads);
    for (const shader::Stroke& stroke : plan_.strokesAt(time, i)) paint(stroke);
  }
}

void GrayScottTwin::advance(const shader::GrayScottRates& rates, int steps, int threads) {
  for (int i = 0; i < steps; ++i) {
    if (threads == 1)
      rows(rates, 0, size_.y);
    else
      tbb::parallel_for(tbb::blocked_range<int>(0, size_.y), [&](const tbb::blocked_range<int>& range) {
        rows(rates, range.begin(), range.end());
      });
    std::swap(u, nextU_);
    std::swap(v, nextV_);
  }
}

void GrayScottTwin::rows(const shader::GrayScottRates& rates, int first, int last) {
  const int width = size_.x;
  for (int y = first; y < last; ++y) {
    const auto row = [&](const std::vector<float>& field, int at) {
      return field.data() + static_cast<std::ptrdiff_t>((at + size_.y) % size_.y) * width;
    };
    const Window wu{row(u, y - 1), row(u, y), row(u, y + 1)};
    const Window wv{row(v, y - 1), row(v, y), row(v, y + 1)};
    float* const toU = nextU_.data() + static_cast<std::ptrdiff_t>(y) * width;
    float* const toV = nextV_.data() + static_cast<std::ptrdiff_t>(y) * width;
    const auto cell = [&](int left, int x, int right, const shader::GrayScottRates& r) {
      const float reacted = shader::reaction(wu.here[x], wv.here[x], r.dt);
      toU[x] = shader::nextU(wu.here[x], wu.laplacian(left, x, right), reacted, r);
      toV[x] = shader::nextV(wv.here[x], wv.laplacian(left, x, right), reacted, r);
    };
    if (!plan_.mapped()) {
      const shader::GrayScottRates base = rates;
      cell(width - 1, 0, 1, base);
      for (int x = 1; x < width - 1; ++x) cell(x - 1, x, x + 1, base);
      cell(width - 2, width - 1, 0, base);
      continue;
    }
    for (int x = 0; x < width; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      shader::GrayScottRates local = rates;
      local.feed = shader::mappedRate(local.feed, rates.feedSpan, feedWeights_[i]);
      local.kill = shader::mappedRate(local.kill, rates.killSpan, killWeights_[i]);
      cell(x == 0 ? width - 1 : x - 1, x, x == width - 1 ? 0 : x + 1, local);
    }
  }
}

void GrayScottTwin::paint(const shader::Stroke& stroke) {
  const glm::ivec4 box = sim::Strokes::box(stroke, size_);
  for (int y = box.y; y < box.y + box.w; ++y)
    for (int x = box.x; x < box.x + box.z; ++x) {
      if (!plan_.strokes().paints(stroke, {x, y})) continue;
      const auto i = static_cast<std::size_t>(y * size_.x + x);
      u[i] = 1.0F - stroke.value;
      v[i] = stroke.value;
    }
}

std::vector<glm::vec4> GrayScottTwin::cells() const {
  std::vector<glm::vec4> elements;
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; x += 2) {
      const auto a = static_cast<std::size_t>(y * size_.x + x);
      const auto b = static_cast<std::size_t>(y * size_.x + (x + 1) % size_.x);
      elements.emplace_back(u[a], v[a], u[b], v[b]);
    }
  return elements;
}
