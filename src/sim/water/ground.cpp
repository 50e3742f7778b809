#include "sim/water/ground.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

namespace {

constexpr int shades = 32, wetnesses = 16;

/// Returns value noise: random values between 0 and 1 at integer lattice points, smoothly interpolated.
float mottle(glm::vec2 p, unsigned seed) {
  const glm::vec2 whole(std::floor(p.x), std::floor(p.y));
  const glm::vec2 beyond = p - whole;
  const glm::vec2 share = beyond * beyond * (3.0F - 2.0F * beyond);
  const auto corner = [&](int x, int y) {
    const shader::uvec3 bits = shader::hash3({static_cast<unsigned>(static_cast<int>(whole.x) + x),
                                              static_cast<unsigned>(static_cast<int>(whole.y) + y), seed});
    return static_cast<float>(bits.x >> 8U) / 16777216.0F;
  };
  const float above = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * share.x;
  const float below = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * share.x;
  return above + (below - above) * share.y;
}

/// Returns fractal noise of five octaves. Each octave has half the feature size and 0.62 times the weight
/// of the previous octave.
float patches(glm::vec2 p) {
  float sum = 0, weight = 0.5F, weights = 0;
  for (unsigned octave = 0; octave < 5; ++octave) {
    sum += weight * mottle(p, octave);
    weights += weight;
    weight *= 0.62F;
    p *= 2.0F;
  }
  return sum / weights;
}

}  // namespace

float groundRim(const WaterPlan& plan) {
  const float shallow = plan.look().shallow;
  float rim = -1e9F;
  for (const glm::vec4& cell : plan.firstCells())
    if (cell.x - cell.w > shallow) rim = std::max(rim, cell.x + 0.05F * (cell.x - cell.w));
  return rim;
}

std::vector<std::uint16_t> groundColors(const WaterPlan& plan) {
  const float shallow = plan.look().shallow;
  const WaterParameters& p = plan.parameters();
  const int width = p.size.x;
  const float perPatch = 14.0F / static_cast<float>(std::max(p.size.x, p.size.y));
  std::vector<std::uint16_t> colors;
  for (const glm::vec4& cell : plan.firstCells()) {
    const auto i = static_cast<int>(colors.size());
    const glm::ivec2 at(i % width, i / width);
    // Ground counts as wet up to a height of 18 times `shallow` above the initial water level. The wetness
    // decreases linearly with the height.
    const float dry = (cell.w - p.level) / (18.0F * shallow);
    const float wetness = 1 - std::clamp(dry, 0.0F, 1.0F);
    const float shade = std::clamp(1.8F * patches(glm::vec2(at) * perPatch) - 0.4F, 0.0F, 1.0F);
    const int color = static_cast<int>(std::lround(wetness * (wetnesses - 1))) * shades +
                      static_cast<int>(std::lround(shade * (shades - 1)));
    colors.push_back(glm::packHalf1x16(static_cast<float>(color)));
  }
  colors.resize((colors.size() + 1) / 2 * 2);  // Pads the array to whole 32-bit words.
  return colors;
}

std::vector<glm::vec4> groundPalette(const WaterPlan& plan) {
  std::vector<glm::vec4> colors;
  for (int wet = 0; wet < wetnesses; ++wet)
    for (int shade = 0; shade < shades; ++shade) {
      const float light = 0.68F + 0.64F * static_cast<float>(shade) / (shades - 1);
      const float dark = 1 - 0.5F * static_cast<float>(wet) / (wetnesses - 1);
      colors.emplace_back(plan.parameters().ground * (light * dark), 0.0F);
    }
  return colors;
}

}  // namespace simreel::sim
