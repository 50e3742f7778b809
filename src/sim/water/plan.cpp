#include "sim/water/plan.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxImageSide = 32768;
constexpr double aimed =
    0.25;  ///< Courant number for automatic substeps; it is so small that no outflow has to be limited.
constexpr double allowed = 0.5;  ///< Courant number beyond which two-dimensional steps are unstable.
constexpr double thinShare = 1e-4, dryShare = 1e-5;  ///< Depths below which water counts as thin or as dry,
                                                     ///< as fractions of the maximum depth.
constexpr int maxSubsteps = 100'000;

/// Scales the strokes to single steps. The value of a stroke with a duration is a rate per second, so it is
/// multiplied by the step's duration.
std::vector<StrokeParameters> perStep(std::vector<StrokeParameters> strokes, double seconds) {
  for (StrokeParameters& stroke : strokes)
    if (stroke.until > stroke.at) stroke.value *= seconds;
  return strokes;
}

/// Returns 3x3 box means. Beyond the border, the border cells are repeated.
std::vector<float> smoothed(const std::vector<float>& heights, glm::ivec2 size) {
  std::vector<float> result;
  result.reserve(heights.size());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      double sum = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          sum += heights[static_cast<std::size_t>(std::clamp(y + j, 0, size.y - 1)) *
                             static_cast<std::size_t>(size.x) +
                         static_cast<std::size_t>(std::clamp(x + i, 0, size.x - 1))];
      result.push_back(static_cast<float>(sum / 9));
    }
  return result;
}

/// Returns the part of a drop's water that has arrived after the part `time` of its duration: a smooth
/// step.
double arrived(double time) {
  const double t = std::clamp(time, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

WaterPlan::WaterPlan(WaterParameters parameters, const std::string& object, int seed, double frameSeconds,
                     bool cells)
    : parameters_(std::move(parameters)), seed_(seed), frameSeconds_(frameSeconds) {
  if (cells)
    makeFirst();
  else
    depth_ = parameters_.greatestDepth.value_or(deepestPossible());
  std::vector<Hull> hulls = FloatPlan::hullsOf(parameters_, object);
  if (cells || parameters_.greatestDepth)
    chooseSubsteps(object, FloatPlan::longestStep(parameters_, hulls));
  strokes_ = Strokes(perStep(parameters_.strokes, stepSeconds()), seed,
                     {parameters_.size, parameters_.isTorus(), "water \"" + object + "\""});
  floats_ = FloatPlan(parameters_, object, std::move(hulls), frameSeconds_, substeps_, depth_, first_);
  for (const WaterDropParameters& drop : parameters_.drops)
    if (box(dropOf(cellsAt(drop.center), drop.radius, drop.height)).z == 0)
      warn(
          "water \"{}\": the drop at {} s, ({:g}, {:g}) m from the middle, falls beside the grid of {:g} "
          "by {:g} m",
          object, drop.at, drop.center.x, drop.center.z,
          static_cast<float>(parameters_.size.x) * parameters_.cell,
          static_cast<float>(parameters_.size.y) * parameters_.cell);
  for (const WaterDrain& drain : parameters_.drains)
    if (box(dropOf(cellsAt(drain.center), drain.radius, 0)).z == 0)
      warn("water \"{}\": the drain at ({:g}, {:g}) m from the middle is beside the grid", object,
           drain.center.x, drain.center.z);
}

glm::dvec2 WaterPlan::cellsAt(const glm::vec3& metres) const {
  const double cell = parameters_.cell;
  return {metres.x / cell + 0.5 * parameters_.size.x, metres.z / cell + 0.5 * parameters_.size.y};
}

std::vector<float> WaterPlan::bedHeights() const {
  const WaterParameters& p = parameters_;
  const auto count = static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(p.size.y);
  std::vector<float> bed(count, p.bed);
  if (!p.terrain.empty()) {
    const std::vector<double> shares = sharesOnGrid(loadLevels(p.terrain, "terrain", maxImageSide), p.size);
    for (std::size_t i = 0; i < count; ++i)
      bed[i] = static_cast<float>(p.terrainLow + (p.terrainHigh - p.terrainLow) * shares[i]);
    for (int i = 0; i < p.terrainSmooth; ++i) bed = smoothed(bed, p.size);
  }
  for (const WaterHill& hill : p.hills) {
    const glm::dvec2 middle = cellsAt(hill.center);
    const double perX = p.cell / static_cast<double>(hill.radii.x);
    const double perY = p.cell / static_cast<double>(hill.radii.z);
    for (int y = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x) {
        const double dx = (x + 0.5 - middle.x) * perX;
        const double dy = (y + 0.5 - middle.y) * perY;
        const double inside = std::max(0.0, 1 - dx * dx - dy * dy);
        bed[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.size.x) +
            static_cast<std::size_t>(x)] += static_cast<float>(hill.height * inside * inside);
      }
  }
  for (float& height : bed) height = shader::waterFlush(height);
  return bed;
}

void WaterPlan::makeFirst() {
  const WaterParameters& p = parameters_;
  const std::vector<float> bed = bedHeights();
  std::vector<float> level(bed.size(), p.level);
  for (const WaterPool& pool : p.pools) {
    const glm::dvec2 a = cellsAt(pool.from);
    const glm::dvec2 b = cellsAt(pool.to);
    for (int y = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x) {
        const glm::dvec2 at(x + 0.5, y + 0.5);
        if (at.x < std::min(a.x, b.x) || at.x > std::max(a.x, b.x) || at.y < std::min(a.y, b.y) ||
            at.y > std::max(a.y, b.y))
          continue;
        level[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.size.x) +
              static_cast<std::size_t>(x)] = pool.level;
      }
  }
  double deepest = 0;
  for (std::size_t i = 0; i < bed.size(); ++i) {
    // The bed of another object is known only when the run begins (WaterKernels::follow).
    const float top = p.groundObject.empty() ? std::max(shader::waterFlush(level[i]), bed[i])
                                             : shader::waterFlush(level[i]);
    first_.emplace_back(top, 0.0F, 0.0F, bed[i]);
    deepest = std::max(deepest, static_cast<double>(top) - bed[i]);
  }
  depth_ = p.greatestDepth.value_or(deepest > 0 ? deepest : p.cell);
}

/// Returns an upper bound of the depth of all cells in metres. Reads the terrain image only to detect
/// errors in it.
double WaterPlan::deepestPossible() const {
  const WaterParameters& p = parameters_;
  double top = p.level, bottom = p.bed;
  if (!p.terrain.empty()) {
    static_cast<void>(loadLevels(p.terrain, "terrain", maxImageSide));
    bottom = std::min<double>(p.terrainLow, p.terrainHigh);
  }
  for (const WaterHill& hill : p.hills) bottom += std::min<double>(hill.height, 0);
  for (const WaterPool& pool : p.pools) top = std::max<double>(top, pool.level);
  return top > bottom ? top - bottom : static_cast<double>(p.cell);
}

// Chooses or checks the number of substeps by the Courant number (u + c) dt / cell.
void WaterPlan::chooseSubsteps(const std::string& object, double longest) {
  const WaterParameters& p = parameters_;
  const double wave = std::sqrt(p.gravity * depth_);
  const double fastest = wave + p.greatestSpeed.value_or(wave);
  const double perFrame = fastest * frameSeconds_ / p.cell;
  if (!p.substeps) {
    const double needed = std::max(std::ceil(perFrame / aimed), std::ceil(frameSeconds_ / longest));
    if (needed > maxSubsteps)
      fail(
          ExitCode::usage,
          "water \"{}\": {:.3g} m/s over cells of {} m need {:.3g} substeps a frame, {} are the most; make "
          "\"cell\" larger",
          object, fastest, p.cell, needed, maxSubsteps);
    substeps_ = std::max(1, static_cast<int>(needed));
    return;
  }
  substeps_ = *p.substeps;
  if (perFrame / substeps_ > allowed)
    warn(
        "water \"{}\": {} a frame {} waves of {:.3g} m/s a Courant number of {:.3g}, and {} is the most "
        "that "
        "is stable; use {} substeps or \"auto\"",
        object, substeps_ == 1 ? "1 substep" : fmt::format("{} substeps", substeps_),
        substeps_ == 1 ? "gives" : "give", fastest, perFrame / substeps_, allowed,
        static_cast<long>(std::ceil(perFrame / allowed)));
}

shader::WaterStep WaterPlan::stepAt(double time, int step) const {
  const WaterParameters& p = parameters_;
  const double dt = stepSeconds();
  const double ratio = dt / p.cell;
  shader::WaterStep s{};
  s.ratio = static_cast<float>(ratio);
  s.halfRatio = static_cast<float>(0.5 * ratio);
  s.gravity = p.gravity;
  s.rain = static_cast<float>(p.rainfall.at(time) / 3.6e6 * dt);
  s.kept = static_cast<float>(1 / (1 + p.drag.at(time) * dt));
  s.manning = static_cast<float>(dt * p.gravity * p.manning * p.manning);
  s.thin = static_cast<float>(std::max(thinShare * depth_, 1e-9));
  s.dry = static_cast<float>(std::max(dryShare * depth_, 1e-10));
  s.share = static_cast<float>(0.25 / ratio);
  s.courant = static_cast<float>(allowed);
  s.west = static_cast<int>(p.sides[0]);
  s.east = static_cast<int>(p.sides[1]);
  s.north = static_cast<int>(p.sides[2]);
  s.south = static_cast<int>(p.sides[3]);
  s.sea = shader::waterFlush(p.level);
  float* const seas[] = {&s.seaWest, &s.seaEast, &s.seaNorth, &s.seaSouth};
  for (const WaterSwell& wave : p.swell) {
    const double now = time + (step + 0.5) * dt;
    const double periods = now / wave.period + wave.phase;
    const auto angle = static_cast<float>(6.283185307179586 * (periods - std::floor(periods)));
    *seas[wave.side] += 0.5F * wave.height.at(now) * shader::exactSin(angle);
  }
  return s;
}

shader::WaterDrop WaterPlan::dropOf(glm::dvec2 center, double radius, float height) const {
  const double cells =
      std::max(radius / parameters_.cell,
               0.75);  // The radius is at least 0.75 cells, so that each drop affects at least one cell.
  return {glm::vec2(center), static_cast<float>(1 / (cells * cells)), height, look().shallow};
}

WaterFalls WaterPlan::fallsAt(double time, int step) const {
  const WaterParameters& p = parameters_;
  const double dt = stepSeconds();
  const double now = time + step * dt;
  WaterFalls falls;
  // Rounds times up to whole steps, so that each event belongs to exactly one step.
  const long state = std::lround(now / dt);
  const auto due = [&](double at) { return std::lround(std::ceil(at / dt - 1e-6)) == state; };
  if (!strokes_.empty()) falls.strokes = strokes_.into(now, dt, state);
  for (const WaterDropParameters& drop : p.drops)
    if (due(drop.at)) falls.drops.push_back(dropOf(cellsAt(drop.center), drop.radius, drop.height));
  for (const WaterDrain& drain : p.drains)
    if (step > 0 && now - 0.5 * dt >= drain.from && now - 0.5 * dt < drain.until)
      falls.drops.push_back(
          dropOf(cellsAt(drain.center), drain.radius, static_cast<float>(-drain.speed.at(now) * dt)));
  if (p.rain) rainInto(falls.drops, now, step);
  return falls;
}

void WaterPlan::rainInto(std::vector<shader::WaterDrop>& drops, double now, int step) const {
  const WaterRain& rain = *parameters_.rain;
  const double dt = stepSeconds();
  const long state = std::lround(now / dt);
  const auto unit = [](unsigned bits) { return bits / 4294967296.0; };
  const double begin = std::floor((now - 2 * dt - rain.duration - rain.from) * rain.rate) - 1;
  const double end = std::ceil((now + 2 * dt - rain.from) * rain.rate);
  for (double i = std::max(begin, 0.0); i <= end; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    const auto random = [&](unsigned purpose) {
      return shader::hash3({static_cast<unsigned>(number),
                            static_cast<unsigned>(number >> 32U) * 8 + purpose,
                            static_cast<unsigned>(seed_)});
    };
    const shader::uvec3 vary = random(6);
    const double at = rain.from + (i + rain.variation * unit(vary.x)) / rain.rate;
    if (at > rain.until) continue;
    double share = 1 + rain.variation * (2 * unit(vary.y) - 1);
    if (rain.duration > 0)
      share *=
          step > 0 ? arrived((now - at) / rain.duration) - arrived((now - dt - at) / rain.duration) : 0;
    else if (std::lround(std::ceil(at / dt - 1e-6)) != state)
      share = 0;
    if (share <= 0) continue;
    const shader::uvec3 r = random(5);
    drops.push_back(dropOf({unit(r.x) * parameters_.size.x, unit(r.y) * parameters_.size.y},
                           rain.radius * (0.5 + unit(r.z)), rain.height * static_cast<float>(share)));
  }
}

glm::ivec4 WaterPlan::box(const shader::WaterDrop& drop) const {
  const double reach = 1 / std::sqrt(static_cast<double>(drop.perRadius2)) + 1;
  const auto held = [](double x, int max) {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, static_cast<double>(max)));
  };
  const glm::ivec2 size = parameters_.size;
  const glm::ivec2 a(held(drop.center.x - reach, size.x), held(drop.center.y - reach, size.y));
  const glm::ivec2 b(held(drop.center.x + reach + 1, size.x), held(drop.center.y + reach + 1, size.y));
  if (b.x <= a.x || b.y <= a.y) return {0, 0, 0, 0};
  return {a.x, a.y, b.x - a.x, b.y - a.y};
}

bool WaterPlan::anythingFalls() const {
  return !strokes_.empty() || !parameters_.drops.empty() || !parameters_.drains.empty() || parameters_.rain;
}

shader::WaterLook WaterPlan::look() const {
  const WaterParameters& p = parameters_;
  const shader::WaterStep step = stepAt(0);
  shader::WaterLook l{};
  l.cell = p.cell;
  l.left = p.position.x - 0.5F * static_cast<float>(p.size.x - 1) * p.cell;
  l.back = p.position.z - 0.5F * static_cast<float>(p.size.y - 1) * p.cell;
  l.base = p.position.y;
  l.shallow = static_cast<float>(5e-3 * depth_);
  l.thin = step.thin;
  l.perClarity = static_cast<float>(1.0 / static_cast<double>(p.clarity));
  l.foam = p.foam;
  l.calm = 0.1F;
  return l;
}

// Returns the colours by depth and foam. By Beer's law, at the depth d, a fraction e^(-d / clarity) of the
// visible colour is the shallow colour and the remaining fraction is the deep colour. Red is absorbed more
// strongly.
std::vector<glm::vec4> WaterPlan::palette() const {
  const glm::vec3 deep = parameters_.deep;
  constexpr glm::vec3 absorbed(1.7F, 0.95F, 1.1F);
  std::vector<glm::vec4> colors;
  for (int foam = 0; foam < shader::foamColors; ++foam)
    for (int depth = 0; depth < shader::depthColors; ++depth) {
      const glm::vec3 ways = absorbed * (-static_cast<float>(depth) / 16.0F);
      const glm::vec3 through(shader::exactExp(ways.x), shader::exactExp(ways.y), shader::exactExp(ways.z));
      const glm::vec3 water = deep + (parameters_.shallow - deep) * through;
      const float share = static_cast<float>(foam) / static_cast<float>(shader::foamColors - 1);
      const float white = share * share;
      colors.emplace_back(water + (glm::vec3(0.9F) - water) * white, 0.0F);
    }
  return colors;
}

}  // namespace simreel::sim
