#include "sim/contact/plan.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <set>
#include <utility>

#include <glm/common.hpp>

namespace simreel::sim {

namespace {

constexpr unsigned noFace = 1U << 31U;
constexpr int maxLevels = 24;

/// Every third bit of the result is one of the ten lowest of `x`.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16U)) & 0x030000ffU;
  x = (x | (x << 8U)) & 0x0300f00fU;
  x = (x | (x << 4U)) & 0x030c30c3U;
  return (x | (x << 2U)) & 0x09249249U;
}

/// The faces of a part along Morton's curve through the box of their middles.
std::vector<std::size_t> mortonOrder(const ContactPart& part) {
  std::vector<glm::vec3> middles;
  for (const glm::uvec3& f : part.faces)
    middles.push_back(glm::vec3(part.positions[f.x]) + glm::vec3(part.positions[f.y]) +
                      glm::vec3(part.positions[f.z]));
  glm::vec3 low = middles.front(), high = low;
  for (const glm::vec3& m : middles) {
    low = glm::min(low, m);
    high = glm::max(high, m);
  }
  const glm::vec3 size = high - low;
  const float widest = std::max({size.x, size.y, size.z, 1e-20F});
  std::vector<std::uint32_t> codes;
  for (const glm::vec3& m : middles) {
    const glm::vec3 place = (m - low) * (1023.0F / widest);
    codes.push_back(spread(static_cast<std::uint32_t>(place.x)) |
                    spread(static_cast<std::uint32_t>(place.y)) << 1U |
                    spread(static_cast<std::uint32_t>(place.z)) << 2U);
  }
  std::vector<std::size_t> order(middles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
  return order;
}

/// Faces with their owned features, vertices numbered from `first` on.
std::vector<glm::uvec4> owners(const ContactPart& part, unsigned first) {
  std::set<unsigned> vertices;
  std::set<std::pair<unsigned, unsigned>> edges;
  std::vector<glm::uvec4> faces;
  for (const std::size_t i : mortonOrder(part)) {
    const glm::uvec3& f = part.faces[i];
    glm::uvec4 face(first + f.x, first + f.y, first + f.z, 0);
    for (int k = 0; k < 3; ++k) {
      if (vertices.insert(f[k]).second) face.w |= 1U << static_cast<unsigned>(k);
      if (edges.insert(std::minmax(f[k], f[(k + 1) % 3])).second) face.w |= 8U << static_cast<unsigned>(k);
    }
    faces.push_back(face);
  }
  return faces;
}

}  // namespace

ContactPlan::ContactPlan(std::span<const ContactPart> parts, double substepSeconds)
    : substepSeconds_(substepSeconds) {
  float lightest = 0;  // greatest inverse mass, least of those that are not held
  for (const ContactPart& part : parts) {
    firsts_.push_back(vertices());
    faces_ += static_cast<int>(part.faces.size());
    for (const glm::vec4& p : part.positions) {
      skins_.emplace_back(0.5F * part.thickness, part.friction);
      if (p.w > 0) lightest = lightest == 0 ? p.w : std::min(lightest, p.w);
    }
  }
  // 2^-30 m of the heaviest: three decimal digits below what floats near 1 m resolve, and room for 2 m.
  const float heaviest = 1.0F / std::max(lightest, 1e-20F);
  quanta_ = 1.0F;
  while (quanta_ * heaviest < 0x1p30F) quanta_ *= 2;
  while (quanta_ * heaviest >= 0x1p31F) quanta_ *= 0.5F;
  // Largest subtrees first, so that each begins at a multiple of its size.
  std::vector<std::size_t> bySize(parts.size());
  std::iota(bySize.begin(), bySize.end(), 0);
  std::stable_sort(bySize.begin(), bySize.end(), [&](std::size_t a, std::size_t b) {
    return std::bit_ceil(parts[a].faces.size()) > std::bit_ceil(parts[b].faces.size());
  });
  for (const std::size_t i : bySize) {
    if (parts[i].faces.empty()) continue;
    const auto faces = owners(parts[i], static_cast<unsigned>(firsts_[i]));
    leaves_.insert(leaves_.end(), faces.begin(), faces.end());
    leaves_.resize(leaves_.size() + std::bit_ceil(faces.size()) - faces.size(),
                   glm::uvec4(0, 0, 0, noFace));
  }
  leaves_.resize(std::bit_ceil(std::max<std::size_t>(leaves_.size(), 2)), glm::uvec4(0, 0, 0, noFace));
  levels_ = std::countr_zero(leaves_.size());
  if (levels_ > maxLevels)
    fail(ExitCode::usage, "contact of {} faces together; there may be {} at most", faces_, 1 << maxLevels);
}

shader::ContactStep ContactPlan::step(bool first, int maxPairs) const {
  shader::ContactStep step{};
  step.perDt = static_cast<float>(1.0 / substepSeconds_);
  step.recovery = 0.2F;
  step.mostRecovery = static_cast<float>(0.3 * substepSeconds_);  // at 0.3 m/s
  step.horizon = 4.0F;
  step.quanta = quanta_;
  step.perQuanta = 1.0F / quanta_;
  step.vertices = vertices();
  step.faces = faces_;
  step.levels = levels_;
  step.forced = first ? 1 : 0;
  step.maxPairs = maxPairs;
  return step;
}

}  // namespace simreel::sim
