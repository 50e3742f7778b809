#include "draw/lights/flicker.hpp"

#include "base/hash.hpp"
#include "sim/core/shader_code.hpp"

#include <cmath>
#include <string>

namespace simreel::draw {

namespace {

/// Returns one-dimensional value noise.
double smoothNoise(std::uint32_t light, std::uint32_t seed, double x) {
  const double below = std::floor(x);
  const double u = x - below;
  // The step wraps modulo 2^32, so that times before 0 also work.
  const auto step = static_cast<std::uint32_t>(static_cast<std::int64_t>(below));
  const double a = shader::signedUnit(shader::hash3({light, step, seed}).x);
  const double b = shader::signedUnit(shader::hash3({light, step + 1, seed}).x);
  return a + (b - a) * (u * u * (3.0 - 2.0 * u));
}

}  // namespace

double flickerNoise(std::uint32_t light, int seed, double x) {
  constexpr std::uint32_t secondNoise = 0x80000000U;  // selects the second noise; seeds do not use this bit
  const auto word = static_cast<std::uint32_t>(seed);
  return (2.0 * smoothNoise(light, word, x) + smoothNoise(light, word | secondNoise, 2.7 * x)) / 3.0;
}

Flickered flickered(const scene::Flicker& flicker, std::string_view name, int seed, double seconds) {
  // Hashes the name, so that a light keeps its flicker when other lights are added or removed.
  const auto light = static_cast<std::uint32_t>(std::stoul(hashHex(name).substr(0, 8), nullptr, 16));
  const double x = seconds * flicker.rate;
  const auto channel = [&](std::uint32_t number) {
    return static_cast<float>(flickerNoise(light + number, seed, x));
  };
  const float sway = flicker.sway.at(seconds);
  return {1.0F + flicker.amount.at(seconds) * channel(0),
          sway * glm::vec3(channel(1), channel(2), channel(3))};
}

}  // namespace simreel::draw
