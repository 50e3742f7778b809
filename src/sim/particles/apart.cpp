#include "sim/particles/apart.hpp"

#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace simreel::sim {

namespace {

/// Maximum number of rounds, and maximum number of rounds times balls, which take some seconds; at least
/// four rounds are computed. If balls still overlap afterwards, contact moves them apart during the run
/// without adding speed.
constexpr std::size_t roundLimit = 200, maxVisits = 1'000'000;
/// Overlap that remains, as a fraction of the distance of two balls.
constexpr float remains = 1e-3F;

using Cell = std::array<int, 3>;
using Cells = std::map<Cell, std::vector<std::size_t>>;

Cell cellOf(const glm::vec4& p, float perCell) {
  const auto index = [&](float x) {
    return static_cast<int>(std::clamp(std::floor(x * perCell), -1e9F, 1e9F));
  };
  return {index(p.x), index(p.y), index(p.z)};
}

/// Returns the direction in which the first of two balls at the same position leaves. Different pairs get
/// different directions, so that many balls at one position do not form a column.
glm::vec3 aside(std::size_t i, std::size_t j) {
  const glm::vec3 v =
      shader::signedUnits(shader::hash3({static_cast<unsigned>(i), static_cast<unsigned>(j), 0x9e3779b9U}));
  const float squared = shader::exactDot(v, v);
  return squared < 1e-4F ? glm::vec3(0, 1, 0) : v * shader::exactInverseSqrt(squared);
}

/// Moves balls i and j at a and b apart if they overlap. Returns true if they overlapped.
bool part(glm::vec4& a, glm::vec4& b, float reach, std::size_t i, std::size_t j) {
  const glm::vec3 separation = glm::vec3(a) - glm::vec3(b);
  const float squared = shader::exactDot(separation, separation);
  if (squared >= reach * reach * (1 - remains)) return false;
  const bool same = squared < 1e-20F;
  const float inverse = shader::exactInverseSqrt(std::max(squared, 1e-20F));
  const glm::vec3 normal = same ? aside(i, j) : separation * inverse;
  const glm::vec3 push = normal * (0.5F * (reach - (same ? 0.0F : squared * inverse)));
  a += glm::vec4(push, 0);
  b -= glm::vec4(push, 0);
  return true;
}

}  // namespace

void moveApart(ParticleCloud& cloud, const shader::BallConstants& balls) {
  const std::size_t count = cloud.positions.size();
  std::vector<float> radii(count);
  for (std::size_t i = 0; i < count; ++i)
    radii[i] = cloud.velocities[i].w < 0 ? 0
               : balls.sizeExponent == 0
                   ? balls.radius
                   : balls.radius * shader::exactPow(cloud.positions[i].w * balls.perMassReference,
                                                     balls.sizeExponent);
  const std::size_t rounds =
      std::clamp<std::size_t>(maxVisits / std::max<std::size_t>(count, 1), 4, roundLimit);
  bool overlaps = true;
  for (std::size_t round = 0; round < rounds && overlaps; ++round) {
    Cells cells;
    for (std::size_t i = 0; i < count; ++i)
      if (radii[i] > 0) cells[cellOf(cloud.positions[i], balls.perCell)].push_back(i);
    overlaps = false;
    for (const auto& [cell, members] : cells)
      for (int around = 0; around < 27; ++around) {
        const auto found =
            cells.find({cell[0] + around % 3 - 1, cell[1] + around / 3 % 3 - 1, cell[2] + around / 9 - 1});
        if (found == cells.end()) continue;
        for (const std::size_t i : members)
          for (const std::size_t j : found->second)
            if (i < j && part(cloud.positions[i], cloud.positions[j], radii[i] + radii[j], i, j))
              overlaps = true;
      }
  }
}

}  // namespace simreel::sim
