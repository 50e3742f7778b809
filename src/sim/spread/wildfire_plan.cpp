#include "sim/spread/wildfire_plan.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/ports/field_source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simreel::sim {

namespace {

constexpr unsigned fuelSeed = 0x68bc21ebU;
constexpr unsigned terrainSeed = 0x02e5be93U;
constexpr unsigned phaseSeed = 0x1b56c4e9U;
constexpr unsigned ditherSeed = 0x967a889bU;
constexpr unsigned inclineSeed = 0x5f356495U;

/// Returns means over 3x3 cells, because otherwise the 256 height levels of an image would be visible as
/// steps in the shading.
std::vector<double> smoothed(const std::vector<double>& values, glm::ivec2 size) {
  const auto at = [&](int x, int y) {
    return values[static_cast<std::size_t>(std::clamp(y, 0, size.y - 1)) *
                      static_cast<std::size_t>(size.x) +
                  static_cast<std::size_t>(std::clamp(x, 0, size.x - 1))];
  };
  std::vector<double> result;
  result.reserve(values.size());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      double sum = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) sum += at(x + i, y + j);
      result.push_back(sum / 9);
    }
  return result;
}

/// Returns an integer from 0 to `max`. It is dithered by the cell's hash, so that levels blend.
unsigned dithered(double fraction, unsigned max, std::size_t cell, unsigned seed) {
  const double level = std::clamp(fraction, 0.0, 1.0) * max + cellFraction(cell, seed);
  return std::min(static_cast<unsigned>(level), max);
}

/// Returns a slope (cells per cell) in sixteenths, clamped to +-maxRise and offset by 128. It is dithered
/// by the cell's hash, so that the mean is exact.
unsigned sixteenths(double rise, std::size_t cell, unsigned seed) {
  constexpr double max = shader::maxRise;
  return static_cast<unsigned>(std::clamp(std::floor(16 * rise + cellFraction(cell, seed)), -max, max) +
                               128);
}

}  // namespace

void WildfireParameters::describe(scene::Fields& f) {
  describeGrid(f);
  f.asset("fuel", fuel, "Picture: the lighter, the more fuel; black is bare ground.");
  f.number("fuelLevel", fuelLevel, {0, 1}, "", "Factor on the fuel everywhere.");
  f.number("patchiness", patchiness, {0, 1}, "", "Fraction of the fuel that noise may take away.");
  f.number("patchSize", patchSize, {1, 1e4}, "cells", "Size of the noise's largest patches.");
  f.idleUnless(patchiness > 0, "patchiness", {"patchSize"}, "fuel with \"patchiness\"");
  f.asset("obstacles", obstacles, "Picture: nothing burns where it is light, as on water.");
  f.asset("terrain", terrain,
          "Picture of heights (heightmap), for the shading and \"slope\"; none: hills of noise.");
  f.number("relief", relief, {0, 1e4}, "cells", "Height of white above black in the terrain.");
  f.number("slope", slope, {0, 3}, "",
           "It spreads e^slope times as likely up a slope of 45 degrees, where the terrain rises a cell in "
           "a cell, and e^-slope times down one, to all sides alike; steeper than 82 degrees counts as "
           "that; 0: the terrain does not affect the fire.");
  f.number("moisture", moisture, {0, 1}, "", "1: nothing catches fire.");
  f.asset("moistureMap", moistureMap, "Picture: white is too wet to burn.");
  f.number("spread", spread, {0, 1}, "per step",
           "Probability that a burning cell lights dry, full fuel beside it without wind.");
  f.group("wind", "Wind that carries the fire.", [&](scene::Fields& w) {
    w.number("direction", windDirection, {-36000, 36000}, "degrees",
             "Direction that it blows to: 0 to the right, 90 up.");
    w.number("strength", windStrength, {0, 20}, "",
             "It spreads e^strength times as likely with the wind and e^-strength times against it; of a "
             "fluid's wind where that has the fluid's \"speed\".");
    w.text("fluid", windFluid,
           "Name of a fluid that blows instead: its rectangle, stretched over the map, at a frame's end.");
    w.idleUnless(!isNothing(windStrength) || !windFluid.empty(), "strength", {"direction"},
                 "wind with a \"strength\"");
    if (windFluid.empty()) return;
    if (!w.given("strength")) windStrength = 1.0F;
    if (w.given("direction"))
      w.error("direction", "the fluid says where it blows; leave out \"direction\"");
  });
  f.integer("burnSteps", burnSteps, {1, 63}, "steps", "Time that a cell burns.");
  f.integer("coolSteps", coolSteps, {7, 1000000}, "steps",
            "Until burnt ground no longer glows, on average.");
  f.optionalGroup(
      "embers", embers, "Sparks that the wind carries ahead.", [](scene::Fields& e, Embers& of) {
        e.number("chance", of.chance, {0, 0.0625}, "per step", "Embers that a burning cell throws.");
        e.number("distance", of.distance, {1, 2000}, "cells", "Longest flight.");
        e.number("spread", of.spread, {0, 1}, "",
                 "Spread of embers to the sides of the wind, as a fraction of the flight.");
      });
  f.list("strokes", strokes, "Timed brush strokes.", [](scene::Fields& s, StrokeParameters& stroke) {
    stroke.describe(s, 1, "1 lights fuel; 0 clears it away.");
  });
  f.leftOut("strokes", "none; in version 2 a fire in the middle");
  f.group("colors", "Linear RGB of the ground.", [&](scene::Fields& c) {
    c.vector("forest", forest, {0, 1}, "", "Much fuel.");
    c.vector("grass", grass, {0, 1}, "", "Little fuel.");
    c.vector("rock", rock, {0, 1}, "", "No fuel.");
    c.vector("water", water, {0, 1}, "", "Obstacles.");
    c.vector("ash", ash, {0, 1}, "", "Burnt ground.");
  });
  describeLook(f);
  litInMiddle = f.version() > 1 && strokes.empty();
  if (litInMiddle) strokes.emplace_back();
  if (litInMiddle) fitPicture(size);
  if (std::none_of(strokes.begin(), strokes.end(), [](const StrokeParameters& s) { return s.value > 0.5; }))
    f.error("strokes", "nothing is ever lit: give a stroke of value 1");
}

WildfirePlan::WildfirePlan(const WildfireParameters& parameters, const std::string& object, int seed,
                           double frameSeconds)
    : parameters_(parameters),
      seed_(static_cast<unsigned>(seed)),
      pace_{parameters.stepsPerSecond, frameSeconds},
      strokes_(parameters.strokes, seed,
               {parameters.size, parameters.border == SpreadParameters::Border::torus,
                "wildfire \"" + object + "\""}) {
  makeGround();
  makeFuel();
}

// Computes the brightness of the ground, which is lit from the top left and therefore gets brighter with
// the slope towards the bottom right.
void WildfirePlan::makeGround() {
  const glm::ivec2 size = parameters_.size;
  auto heights = parameters_.terrain.empty() ? hashNoise(size, 0.3 * size.y + 4, seed_ ^ terrainSeed)
                                             : smoothLevels(parameters_.terrain, "terrain map", size);
  heights = smoothed(smoothed(heights, size), size);
  const auto at = [&](int x, int y) {
    return heights[static_cast<std::size_t>(std::clamp(y, 0, size.y - 1)) *
                       static_cast<std::size_t>(size.x) +
                   static_cast<std::size_t>(std::clamp(x, 0, size.x - 1))];
  };
  ground_.reserve(heights.size());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const double riseX = parameters_.relief * 0.5 * (at(x + 1, y) - at(x - 1, y));
      const double riseY = parameters_.relief * 0.5 * (at(x, y + 1) - at(x, y - 1));
      const double rise = riseX + riseY;
      const double shade = 0.5 + 0.5 * rise / std::sqrt(0.2 + rise * rise);
      const std::size_t cell = ground_.size();
      if (parameters_.slope > 0)
        inclines_.push_back(
            static_cast<std::uint16_t>(sixteenths(riseX, cell, seed_ ^ inclineSeed) |
                                       sixteenths(riseY, cell, ~seed_ ^ inclineSeed) << 8U));
      const auto phase = static_cast<unsigned>(16 * cellFraction(cell, seed_ ^ phaseSeed));
      ground_.push_back(static_cast<std::uint8_t>(phase << 4U | dithered(shade, 15, cell, ditherSeed)));
    }
}

void WildfirePlan::makeFuel() {
  const WildfireParameters& p = parameters_;
  const auto count = static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(p.size.y);
  const auto noise = hashNoise(p.size, p.patchSize, seed_ ^ fuelSeed);
  const auto map = [&](const std::filesystem::path& file, const char* what, double otherwise) {
    return file.empty() ? std::vector<double>(count, otherwise) : smoothLevels(file, what, p.size);
  };
  const auto fuel = map(p.fuel, "fuel map", 1);
  const auto obstacles = map(p.obstacles, "obstacle map", 0);
  const auto moisture = map(p.moistureMap, "moisture map", 0);
  cells_.resize(count);
  fuels_.resize(count);
  bool burns = false;
  for (std::size_t i = 0; i < count; ++i) {
    // Octave noise is concentrated around its mean, so it is stretched to give both sparse and dense
    // patches.
    const double patch = std::clamp(0.5 + 1.8 * (noise[i] - 0.5), 0.0, 1.0);
    const double level = fuel[i] * p.fuelLevel * (1 - p.patchiness * (1 - patch));
    const unsigned shade = ground_[i] & 15U;
    if (obstacles[i] > 0.5) {
      cells_[i] = static_cast<std::uint8_t>(shader::classNobody | 16U | shade);
    } else if (level * 255 < 0.5) {
      cells_[i] = static_cast<std::uint8_t>(shader::classNobody | shade);
    } else {
      fuels_[i] = static_cast<std::uint8_t>(std::lround(255 * level * (1 - moisture[i])));
      burns = burns || fuels_[i] > 0;
      cells_[i] = static_cast<std::uint8_t>(shader::classReady |
                                            dithered(level, 3, i, ditherSeed + 1) << 4U | shade);
    }
  }
  if (!burns)
    fail(ExitCode::usage,
         "nothing on the wildfire's map can burn: no cell has fuel that is dry and no obstacle");
}

std::vector<glm::vec4> WildfirePlan::climbFactors() const {
  std::vector<glm::vec4> factors(128);
  for (int i = 0; i < 512; ++i) {
    const double tangent = (i % 256 - 128) / 16.0 / (i < 256 ? 1.0 : std::numbers::sqrt2);
    factors[static_cast<std::size_t>(i / 4)][i % 4] =
        static_cast<float>(ieee::exp(parameters_.slope * tangent));
  }
  return factors;
}

shader::WildfireStep WildfirePlan::stepAt(double time) const {
  const WildfireParameters& p = parameters_;
  const double angle =
      std::fmod(static_cast<double>(p.windDirection.at(time)), 360.0) * std::numbers::pi / 180;
  const double given = static_cast<double>(p.windStrength.at(time));
  const double strength = p.windFluid.empty() ? given : 0.0;
  const double windX = ieee::cos(angle);
  const double windY = -ieee::sin(angle);
  const double base =
      static_cast<double>(p.spread.at(time)) * (1 - static_cast<double>(p.moisture.at(time)));
  shader::WildfireStep data{};
  unsigned d = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      // Fire spreads from the neighbour at (x, y) in the direction (-x, -y). Diagonal distances are longer,
      // so the probability is divided by the distance.
      const double length = std::sqrt(static_cast<double>(x * x + y * y));
      const double along = -(x * windX + y * windY) / length;
      const double chance = std::min(1.0, base * ieee::exp(strength * along) / length);
      data.spread[d / 4][static_cast<int>(d % 4)] = static_cast<unsigned>(std::lround(65536 * chance));
      ++d;
    }
  // A cell ages seven times in coolSteps steps, and each time it takes one round through the sixteen
  // phases. phases() returns the number of phases completed after `steps` steps.
  const auto phases = [&](std::uint64_t steps) {
    return static_cast<unsigned>(steps * 112 / static_cast<unsigned>(p.coolSteps));
  };
  const unsigned firstPhase = phases(done_);
  data.step = done_;
  data.seed = seed_;
  data.constants = p;
  data.firstPhase = firstPhase & 15U;
  data.phases = phases(done_ + 1ULL) - firstPhase;
  if (!p.embers) return data;
  data.emberThreshold = static_cast<unsigned>(std::lround(p.embers->chance * 16 * 134217728.0));
  data.emberReach = given > 0 ? static_cast<float>(256 * p.embers->distance / (2048 * given)) : 0.0F;
  data.emberFlight = {std::lround(256 * p.embers->distance * windX),
                      std::lround(256 * p.embers->distance * windY)};
  data.emberSpread = static_cast<int>(std::lround(256 * p.embers->spread));
  return data;
}

std::vector<shader::Stroke> WildfirePlan::firstStrokes(double time) const {
  return strokes_.into(pace_.during(time).time, 1.0 / parameters_.stepsPerSecond, 0);
}

std::vector<WildfirePlan::Step> WildfirePlan::frame(double time) {
  const Pace::Steps pace = pace_.during(time);
  const double seconds = 1.0 / parameters_.stepsPerSecond;
  std::vector<Step> steps;
  for (int i = 0; i < pace.count; ++i, ++done_) {
    const double t = pace.time + i * seconds;
    steps.push_back({stepAt(t), strokes_.into(t + seconds, seconds, static_cast<long>(done_) + 1)});
  }
  return steps;
}

std::vector<glm::vec3> WildfirePlan::palette() const {
  const WildfireParameters& p = parameters_;
  const auto shaded = [](const glm::vec3& color, double fraction) {
    return color * static_cast<float>(0.35 + 1.3 * fraction);
  };
  std::vector<glm::vec3> colors;
  for (int i = 0; i < 64; ++i) {  // Ground classes that cannot burn: 0 is rock, 1 is water, and the others
                                  // are unused.
    const bool isWater = i / 16 == 1;
    colors.push_back(isWater ? p.water * static_cast<float>(0.85 + 0.3 * (i % 16) / 15.0)
                             : shaded(p.rock, i % 16 / 15.0));
  }
  for (int i = 0; i < 64; ++i) {
    const int density = i / 16;
    colors.push_back(
        shaded(glm::mix(p.grass, p.forest, static_cast<float>(density) / 3.0F), i % 16 / 15.0));
  }
  const std::vector<glm::vec3> flames = {
      {1.0F, 0.93F, 0.62F}, {1.0F, 0.62F, 0.14F}, {0.95F, 0.26F, 0.03F}, {0.55F, 0.07F, 0.01F}};
  appendGradient(colors, flames, std::max(2, p.burnSteps));
  while (colors.size() < 192) colors.push_back(flames.back());
  for (int i = 0; i < 64; ++i) {
    const int age = i / 8;
    // Cells cool at different times, so embers appear as specks in black char, which then fades to ash.
    const float old = static_cast<float>(age) / 7.0F;
    const float cool = 1.0F - old;
    const float hot = cool * cool * cool * cool * cool * cool * cool;
    const glm::vec3 glow = glm::vec3(0.40F, 0.050F, 0.006F) * hot;
    colors.push_back(shaded(p.ash * (0.22F + 0.78F * old), i % 8 / 7.0) + glow);
  }
  return colors;
}

void WildfireParameters::ports(Ports& ports) const {
  ports.provide<FieldSource>();
  ports.want<FluidWind>(windFluid, {"wind", "fluid"});
}

std::span<const scene::Quantity> WildfireParameters::quantities() const {
  static const scene::Quantity table[] = {{"unburnt", "cells", "Cells with fuel that has not burnt."},
                                          {"burning", "cells", "Cells on fire."},
                                          {"burnt", "cells", "Cells that have burnt."},
                                          {"bare", "cells", "Cells without fuel, and obstacles."}};
  return table;
}

}  // namespace simreel::sim
