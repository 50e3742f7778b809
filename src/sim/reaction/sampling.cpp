#include "sim/reaction/sampling.hpp"

#include "base/error.hpp"
#include "sim/reaction/rule/model.hpp"

#include <algorithm>
#include <cstddef>

namespace simreel::sim {

namespace {

using shader::reaction::Between;
using shader::reaction::betweenOf;
using shader::reaction::grained;

float storedSample(float value) {
  return grained(std::clamp(value, -1e20F, 1e20F), storedGrain);
}

class Sampled {
 public:
  Sampled(const std::vector<float>& values, glm::ivec2 sources)
      : values_(values), width_(static_cast<std::size_t>(sources.x)) {
    SIMREEL_CHECK_EQ(values.size(), width_ * static_cast<std::size_t>(sources.y));
  }
  [[nodiscard]] float between(const Between& across, const Between& down) const {
    return grained(inLayer(across, down, 0), storedGrain);
  }
  /// Returns a trilinear sample of a volume whose layers have `rows` rows each.
  [[nodiscard]] float between(const Between& across, const Between& down, const Between& deep,
                              int rows) const {
    return grained(betweenOf(inLayer(across, down, deep.before * rows),
                             inLayer(across, down, deep.after * rows), deep.share),
                   storedGrain);
  }

 private:
  [[nodiscard]] float inLayer(const Between& across, const Between& down, int top) const {
    const float above =
        betweenOf(at(across.before, top + down.before), at(across.after, top + down.before), across.share);
    const float below =
        betweenOf(at(across.before, top + down.after), at(across.after, top + down.after), across.share);
    return betweenOf(above, below, down.share);
  }
  [[nodiscard]] float at(int x, int y) const {
    return storedSample(values_[static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x)]);
  }
  const std::vector<float>& values_;
  std::size_t width_;
};

}  // namespace

std::vector<float> sampledOnGrid(const std::vector<float>& values, glm::ivec2 sources, glm::ivec2 size) {
  const Sampled source(values, sources);
  std::vector<float> sampled;
  sampled.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int y = 0; y < size.y; ++y) {
    const Between down = shader::reaction::betweenCells(y, size.y, sources.y);
    for (int x = 0; x < size.x; ++x)
      sampled.push_back(source.between(shader::reaction::betweenCells(x, size.x, sources.x), down));
  }
  return sampled;
}

std::vector<float> sampledInVolume(const std::vector<float>& values, glm::ivec3 sources, glm::ivec3 size) {
  const Sampled source(values, {sources.x, sources.y * sources.z});
  std::vector<float> sampled;
  for (int z = 0; z < size.z; ++z) {
    const Between deep = shader::reaction::betweenCells(z, size.z, sources.z);
    for (int y = 0; y < size.y; ++y) {
      const Between down = shader::reaction::betweenCells(y, size.y, sources.y);
      for (int x = 0; x < size.x; ++x)
        sampled.push_back(
            source.between(shader::reaction::betweenCells(x, size.x, sources.x), down, deep, sources.y));
    }
  }
  return sampled;
}

std::vector<float> sampledAt(const std::vector<float>& values, glm::ivec2 sources,
                             const std::vector<glm::ivec2>& places) {
  const Sampled source(values, sources);
  std::vector<float> sampled;
  sampled.reserve(places.size());
  for (const glm::ivec2& place : places)
    sampled.push_back(source.between(shader::reaction::betweenAt(place.x, sources.x),
                                     shader::reaction::betweenAt(place.y, sources.y)));
  return sampled;
}

std::vector<float> sampledCells(const std::vector<float>& values) {
  std::vector<float> sampled;
  sampled.reserve(values.size());
  for (const float value : values) sampled.push_back(storedSample(value));
  return sampled;
}

}  // namespace simreel::sim
