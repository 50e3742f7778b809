#pragma once
#include "base/error.hpp"
#include "sim/particles/file.hpp"

#include <cmath>

namespace simreel::fuzz {

/// Reads particles. Checks that accepted particles are complete and finite.
inline void readCloud(std::string_view bytes, const char* name) {
  constexpr int max = 1000;
  const sim::ParticleCloud cloud = sim::parseParticles(bytes, name, 1.0F, max);
  SIMREEL_CHECK_EQ(cloud.positions.size(), cloud.velocities.size());
  SIMREEL_CHECK(!cloud.positions.empty() && cloud.positions.size() <= max);
  for (const auto& p : cloud.positions)
    SIMREEL_CHECK(std::abs(p.x) <= 1e7F && std::abs(p.y) <= 1e7F && std::abs(p.z) <= 1e7F && p.w > 0);
}

}  // namespace simreel::fuzz
