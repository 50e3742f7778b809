#include "sim/cloth/skin_pins.hpp"

#include "base/error.hpp"

#include <cstddef>

namespace simreel::sim {

void SkinPins::attach(const std::vector<PinGroup>& groups, const std::vector<int>& owners,
                      const std::vector<glm::vec3>& rest, const HeldBySkin& heldBySkin, double startTime) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!groups[g].onSkin()) continue;
    std::vector<glm::dvec3> points;
    for (unsigned i = 0; i < owners.size(); ++i) {
      if (owners[i] != static_cast<int>(g)) continue;
      points.emplace_back(rest[i]);
      particles_.push_back(i);
    }
    if (points.empty()) continue;
    SIMREEL_CHECK(heldBySkin);
    holders_.push_back(heldBySkin(groups[g].to, points, startTime));
  }
}

std::vector<glm::vec4> SkinPins::frame(double begin, double end) const {
  std::vector<glm::vec4> ways;
  for (const SkinHolder& holder : holders_) {
    const std::vector<glm::dvec3> first = holder(begin);
    const std::vector<glm::dvec3> last = holder(end);
    for (std::size_t k = 0; k < first.size(); ++k) {
      const auto number = static_cast<float>(particles_[ways.size() / 2]);
      ways.emplace_back(glm::vec3(first[k]), number);
      ways.emplace_back(glm::vec3(last[k]), 0.0F);
    }
  }
  return ways;
}

}  // namespace simreel::sim
