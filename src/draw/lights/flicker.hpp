#pragma once
#include "scene/light.hpp"

#include <cstdint>
#include <string_view>

#include <glm/vec3.hpp>

namespace simreel::draw {

/// Smooth noise of time, the same bits on every machine: at whole x the value is the integer hash of
/// (light, x, seed), -1 to 1, in between it goes along 3u^2 - 2u^3; a third of it is a second noise, 2.7
/// times as fast. Its mean is 0. `light` tells lights and their channels apart.
[[nodiscard]] double flickerNoise(std::uint32_t light, int seed, double x);

/// What a flicker makes of its light at `seconds`.
struct Flickered {
  float factor = 1.0F;  ///< on the intensity: 1 - amount to 1 + amount
  glm::vec3 moved{0};   ///< m; each component at most `sway`
};
[[nodiscard]] Flickered flickered(const scene::Flicker& flicker, std::string_view name, int seed,
                                  double seconds);

}  // namespace simreel::draw
