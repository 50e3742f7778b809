#include "sim/reaction/sampling.hpp"

#include "base/error.hpp"
#include "sim/reaction/model.hpp"

#include <algorithm>
#include <cstddef>

namespace simreel::sim {

std::vector<float> sampledOnGrid(const std::vector<float>& values, glm::ivec2 sources, glm::ivec2 size) {
  using shader::reaction::betweenOf;
  using shader::reaction::grained;
  const auto width = static_cast<std::size_t>(sources.x);
  SIMREEL_CHECK_EQ(values.size(), width * static_cast<std::size_t>(sources.y));
  const auto at = [&](int x, int y) {
    const float value = values[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
    return grained(std::clamp(value, -1e20F, 1e20F), storedGrain);
  };
  std::vector<float> sampled;
  sampled.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int y = 0; y < size.y; ++y) {
    const auto down = shader::reaction::betweenCells(y, size.y, sources.y);
    for (int x = 0; x < size.x; ++x) {
      const auto across = shader::reaction::betweenCells(x, size.x, sources.x);
      const float above =
          betweenOf(at(across.before, down.before), at(across.after, down.before), across.share);
      const float below =
          betweenOf(at(across.before, down.after), at(across.after, down.after), across.share);
      sampled.push_back(grained(betweenOf(above, below, down.share), storedGrain));
    }
  }
  return sampled;
}

}  // namespace simreel::sim
