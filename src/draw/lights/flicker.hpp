#pragma once
#include "scene/light.hpp"

#include <cstdint>
#include <string_view>

#include <glm/vec3.hpp>

namespace simreel::draw {

/// Returns smooth noise of time x with mean 0 and the same bits on every machine. At an integer x the noise
/// is an integer hash of (light, x, seed) in -1 to 1. Between integers, 3u^2 - 2u^3 of the fractional part
/// u interpolates. A second noise, 2.7 times as fast, has a weight of one third. `light` is a different
/// number for each light and channel.
[[nodiscard]] double flickerNoise(std::uint32_t light, int seed, double x);

/// Effect of flickering on a light.
struct Flickered {
  float factor = 1.0F;  ///< factor of the intensity, from 1 - amount to 1 + amount
  glm::vec3 moved{0};   ///< displacement (m); each component at most `sway`
};
[[nodiscard]] Flickered flickered(const scene::Flicker& flicker, std::string_view name, int seed,
                                  double seconds);

}  // namespace simreel::draw
