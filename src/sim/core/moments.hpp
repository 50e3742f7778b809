#pragma once
#include "scene/value/animated.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Sample times (seconds, ascending) that cover the whole motion of a keyframed object. They include each
/// keyframe, the moment just before each jump, and enough times between rotation keys (degrees) that no
/// corner moves more than 1% of its radius beyond the sampled positions.
class SampleTimes {
 public:
  template <class T>
  void add(const scene::Animated<T>& value) {
    const auto& keys = value.keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
      seconds_.push_back(keys[i].time);
      if (i > 0 && keys[i].time == keys[i - 1].time)
        seconds_.push_back(std::nextafter(keys[i].time, -std::numeric_limits<double>::infinity()));
    }
  }
  void addRotation(const scene::Animated<glm::vec3>& rotation) {
    add(rotation);
    const auto& keys = rotation.keys();
    for (std::size_t i = 1; i < keys.size(); ++i) {
      const glm::vec3 turn = keys[i].value - keys[i - 1].value;
      const float maximum = std::max({std::abs(turn.x), std::abs(turn.y), std::abs(turn.z)});
      // The maximum number of samples is prime, so that samples of several full turns do not all fall on
      // the same few angles.
      constexpr float degrees = 16, samples = 23;
      const int intervals = static_cast<int>(std::clamp(std::ceil(maximum / degrees), 1.0F, samples));
      for (int k = 1; k < intervals; ++k)
        seconds_.push_back(keys[i - 1].time + (keys[i].time - keys[i - 1].time) * k / intervals);
    }
  }
  [[nodiscard]] std::vector<double> all() const {
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    return sorted;
  }

 private:
  std::vector<double> seconds_;
};

/// Returns the sample times of a position, a rotation and an optional scale.
inline std::vector<double> momentsOf(const scene::Animated<glm::vec3>& position,
                                     const scene::Animated<glm::vec3>& rotation,
                                     const scene::Animated<float>& scale = 1.0F) {
  SampleTimes moments;
  moments.add(position);
  moments.addRotation(rotation);
  if (scale.moves()) moments.add(scale);
  return moments.all();
}

/// Returns the time (seconds) of the latest jump among all `values`, at or before `seconds`.
template <class... T>
double lastJump(double seconds, const scene::Animated<T>&... values) {
  return std::max({values.jumpedBy(seconds)...});
}

}  // namespace simreel::sim
