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

constexpr int maxLevels = 24;

/// Moves bit i of the ten lowest bits of `x` to bit 3 i of the result.
std::uint32_t spread(std::uint32_t x) {
  x = (x | (x << 16U)) & 0x030000ffU;
  x = (x | (x << 8U)) & 0x0300f00fU;
  x = (x | (x << 4U)) & 0x030c30c3U;
  return (x | (x << 2U)) & 0x09249249U;
}

using Leaves = std::vector<glm::uvec4>;

/// Sorts the faces or edges of a part along the Morton curve through the bounding box of their centres.
Leaves mortonOrder(const Leaves& leaves, const std::vector<glm::vec4>& positions) {
  std::vector<glm::vec3> middles;
  for (const glm::uvec4& leaf : leaves)
    middles.push_back(glm::vec3(positions[leaf.x]) + glm::vec3(positions[leaf.y]) +
                      glm::vec3(positions[leaf.z]));
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
  std::vector<std::size_t> order(leaves.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return codes[a] < codes[b]; });
  Leaves sorted;
  for (const std::size_t i : order) sorted.push_back(leaves[i]);
  return sorted;
}

Leaves facesOf(const ContactPart& part) {
  Leaves faces;
  for (const glm::uvec3& f : part.faces) faces.emplace_back(f, 0);
  return faces;
}

Leaves edgesOf(const ContactPart& part) {
  std::set<std::pair<unsigned, unsigned>> edges;
  for (const glm::uvec3& f : part.faces)
    for (int k = 0; k < 3; ++k) edges.insert(std::minmax(f[k], f[(k + 1) % 3]));
  Leaves leaves;
  for (const auto& [a, b] : edges) leaves.emplace_back(a, b, b, 0);
  return leaves;
}

constexpr glm::uvec4 none(0, 0, 0, 1);

/// Returns the leaves of a tree over all cloths or over all solids. The largest subtrees come first, so
/// that each subtree starts at a multiple of its size.
Leaves leavesOf(std::span<const ContactPart> parts, const std::vector<int>& firsts, bool solid,
                Leaves (*featuresOf)(const ContactPart&)) {
  std::vector<Leaves> subtrees;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].solid != solid) continue;
    Leaves leaves = featuresOf(parts[i]);
    if (leaves.empty()) continue;
    leaves = mortonOrder(leaves, parts[i].positions);
    const auto first = static_cast<unsigned>(firsts[i]);
    for (glm::uvec4& leaf : leaves) leaf += glm::uvec4(first, first, first, 0);
    leaves.resize(std::bit_ceil(leaves.size()), none);
    subtrees.push_back(std::move(leaves));
  }
  std::stable_sort(subtrees.begin(), subtrees.end(),
                   [](const Leaves& a, const Leaves& b) { return a.size() > b.size(); });
  Leaves all;
  for (const Leaves& subtree : subtrees) all.insert(all.end(), subtree.begin(), subtree.end());
  if (!all.empty() || !solid) all.resize(std::bit_ceil(std::max<std::size_t>(all.size(), 2)), none);
  return all;
}

/// Returns the leaves of the cloths, followed by an equal number of leaves for the solids, if there are
/// any.
Leaves bothHalves(std::span<const ContactPart> parts, const std::vector<int>& firsts,
                  Leaves (*featuresOf)(const ContactPart&)) {
  Leaves all = leavesOf(parts, firsts, false, featuresOf);
  Leaves solids = leavesOf(parts, firsts, true, featuresOf);
  if (std::any_of(parts.begin(), parts.end(), [](const ContactPart& part) { return part.solid; })) {
    const std::size_t half = std::max(all.size(), solids.size());
    all.resize(half, none);
    solids.resize(half, none);
    all.insert(all.end(), solids.begin(), solids.end());
  }
  if (std::countr_zero(all.size()) > maxLevels)
    fail(ExitCode::usage,
         "contact has {} faces or edges in total, but at most {} are allowed; use coarser meshes",
         all.size(), 1 << maxLevels);
  return all;
}

}  // namespace

ContactPlan::ContactPlan(std::span<const ContactPart> parts, double substepSeconds)
    : substepSeconds_(substepSeconds) {
  float lightest = 0;  // Minimum inverse mass of all cloth vertices that are not pinned.
  float thickest = 0, heaviestBall = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const ContactPart& part = parts[k];
    firsts_.push_back(vertices());
    if (part.solid) {
      skins_.insert(skins_.end(), part.positions.size(), glm::vec4(thickest, part.friction, 0, -1));
      continue;
    }
    SIMREEL_CHECK(movable_ == vertices());
    if (part.balls) {
      const auto met = std::find_if(parts.begin(), parts.end(), [&](const ContactPart& other) {
        return !part.meets.empty() && other.name == part.meets;
      });
      const auto number = met == parts.end() ? -1.0F : static_cast<float>(met - parts.begin());
      skins_.insert(skins_.end(), part.positions.size(),
                    glm::vec4(std::max(part.thickness, thickest), -1, part.bounce, number));
      heaviestBall = std::max(heaviestBall, part.heaviest);
      movable_ = vertices();
      continue;
    }
    SIMREEL_CHECK(balls_ == vertices());
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const glm::vec4& p = part.positions[i];
      const float thick = part.rooms.empty() ? part.thickness : std::min(part.thickness, part.rooms[i]);
      skins_.emplace_back(0.5F * thick, part.friction, 0, static_cast<float>(k));
      thickest = std::max(thickest, 0.5F * thick);
      if (p.w > 0) lightest = lightest == 0 ? p.w : std::min(lightest, p.w);
    }
    movable_ = balls_ = vertices();
  }
  // One fixed-point unit of impulse moves the heaviest vertex by 2^-30 m, which is three decimal digits
  // below the float resolution near 1 m; the sums then have a range of 2 m. A particle counts with an
  // eighth of its mass, because it seldom moves far in a substep.
  const float heaviest = std::max(lightest > 0 ? 1.0F / lightest : 0, 0.125F * heaviestBall);
  quanta_ = 1.0F;
  while (heaviest > 0 && quanta_ * heaviest < 0x1p30F) quanta_ *= 2;
  while (quanta_ * heaviest >= 0x1p31F) quanta_ *= 0.5F;
  faces_ = bothHalves(parts, firsts_, facesOf);
  edges_ = bothHalves(parts, firsts_, edgesOf);
}

int ContactPlan::faceLevels() const {
  return std::countr_zero(faces_.size());
}
int ContactPlan::edgeLevels() const {
  return std::countr_zero(edges_.size());
}

shader::ContactStep ContactPlan::step(bool first, int maxPairs) const {
  shader::ContactStep step{};
  step.perDt = static_cast<float>(1.0 / substepSeconds_);
  step.recovery = 0.2F;
  step.maxRecovery = static_cast<float>(
      0.3 * substepSeconds_);  // Limits the speed at which overlaps are removed to 0.3 m/s.
  step.horizon = 8.0F;
  step.quanta = quanta_;
  step.perQuanta = 1.0F / quanta_;
  step.bounceFrom =
      static_cast<float>(0.1 * substepSeconds_);  // Impacts bounce if their speed is at least 0.1 m/s.
  step.vertices = vertices();
  step.movable = movable_;
  step.balls = balls_;
  step.faceLevels = faceLevels();
  step.edgeLevels = edgeLevels();
  step.forced = first ? 1 : 0;
  step.maxPairs = maxPairs;
  return step;
}

}  // namespace simreel::sim
