#include "sim/water/float_plan.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr double waterDensity = 1000;       ///< Density of water in kg/m^3.
constexpr double flowFineness = 268435456;  ///< Number of fixed-point units in the maximum discharge. It is
                                            ///< large because the contribution of a single point is small.
constexpr double fineness = 4194304;        ///< Number of fixed-point units in the maximum depth.
constexpr int largestReach = 1024;  ///< Maximum width, in cells, of the window of cells under a body.

/// Returns the largest power of two that is at most `x`.
double powerBelow(double x) {
  double unit = 1;
  while (unit > x) unit *= 0.5;
  while (2 * unit <= x) unit *= 2;
  return unit;
}

/// Returns the quaternion (x, y, z, w) of a rotation matrix.
glm::vec4 quaternionOf(const glm::mat4& m) {
  const double trace = static_cast<double>(m[0][0]) + m[1][1] + m[2][2];
  glm::dvec4 q;
  if (trace > 0) {
    q = {m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0], 1 + trace};
  } else {
    const int i = m[0][0] > m[1][1] ? (m[0][0] > m[2][2] ? 0 : 2) : (m[1][1] > m[2][2] ? 1 : 2);
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    q[i] = 1.0 + m[i][i] - m[j][j] - m[k][k];
    q[j] = m[i][j] + m[j][i];
    q[k] = m[i][k] + m[k][i];
    q[3] = m[j][k] - m[k][j];
  }
  return {q / std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w)};
}

glm::dvec3 times(const std::array<double, 6>& m, const glm::dvec3& v) {
  return {m[0] * v.x + m[3] * v.y + m[4] * v.z, m[3] * v.x + m[1] * v.y + m[5] * v.z,
          m[4] * v.x + m[5] * v.y + m[2] * v.z};
}

glm::vec4 four(double x, double y, double z, double w) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), static_cast<float>(w)};
}

}  // namespace

std::vector<Hull> FloatPlan::hullsOf(const WaterParameters& water, const std::string& object) {
  std::vector<Hull> hulls;
  for (std::size_t i = 0; i < water.floats.size(); ++i)
    hulls.emplace_back(water.floats[i], fmt::format("{}.floats.{}", object, i));
  return hulls;
}

// A body resting on the ground sinks in by g dt^2 / (0.25 s), where s is the fraction of its points in
// contact, about 3%. The step limits this depth to 1/20 of the body's height or a quarter of a cell,
// whichever is larger.
double FloatPlan::longestStep(const WaterParameters& water, const std::vector<Hull>& hulls) {
  double seconds = 1e9;
  for (const Hull& hull : hulls) {
    const double sinks = std::max(0.05 * hull.height, 0.25 * water.cell);
    seconds = std::min(seconds, std::sqrt(sinks * 0.25 * 0.03 / water.gravity));
  }
  return seconds;
}

// The slowest standing wave between walls has a wavelength of twice the grid's length, so its angular
// frequency is omega = pi c / length, where c is the wave speed. The time constant T satisfies omega T = 2.
double FloatPlan::followSeconds(const WaterParameters& water, double depth) {
  const double length = std::max(water.size.x, water.size.y) * static_cast<double>(water.cell);
  return 2 * length / (std::numbers::pi * std::sqrt(water.gravity * depth));
}

FloatPlan::FloatPlan(const WaterParameters& water, const std::string& object, std::vector<Hull> hulls,
                     double frameSeconds, int substeps, double depth, const std::vector<glm::vec4>& cells)
    : floats_(water.floats), hulls_(std::move(hulls)), frameSeconds_(frameSeconds) {
  if (floats_.empty()) return;
  describeStep(water, frameSeconds / substeps, depth);
  for (std::size_t i = 0; i < floats_.size(); ++i)
    addBody(water, fmt::format("{}.floats.{}", object, i), i, depth, cells);
}

void FloatPlan::describeStep(const WaterParameters& water, double dt, double depth) {
  const double cell = water.cell;
  const double depthUnit = powerBelow(depth / fineness);
  const double flowUnit = powerBelow(depth * std::sqrt(water.gravity * depth) / flowFineness);
  shader::FloatStep& s = step_;
  s.dt = static_cast<float>(dt);
  s.gravity = water.gravity;
  s.density = static_cast<float>(waterDensity);
  s.perCell = static_cast<float>(1 / cell);
  s.columns = 0.5F * static_cast<float>(water.size.x);
  s.rows = 0.5F * static_cast<float>(water.size.y);
  s.halfX = static_cast<float>(0.5 * water.size.x * cell);
  s.halfZ = static_cast<float>(0.5 * water.size.y * cell);
  s.depthUnit = static_cast<float>(depthUnit);
  s.perDepthUnit = static_cast<float>(1 / (depthUnit * cell * cell));
  s.flowUnit = static_cast<float>(flowUnit);
  s.perFlowUnit = static_cast<float>(dt / (waterDensity * flowUnit * cell * cell));
  s.stiff = static_cast<float>(0.25 / (dt * dt));
  s.damp = static_cast<float>(0.4 / dt);
  s.deepest = static_cast<float>(0.5 * cell);
  s.thin = static_cast<float>(std::max(1e-4 * depth, 1e-9));
  s.dry = static_cast<float>(5e-3 * depth);
  s.maximum = static_cast<float>(cell / dt);
  s.west = static_cast<int>(water.sides[0]);
  s.east = static_cast<int>(water.sides[1]);
  s.north = static_cast<int>(water.sides[2]);
  s.south = static_cast<int>(water.sides[3]);
  s.count = static_cast<int>(floats_.size());
}

/// Warns if the body in its initial rotation is wider than the distance between two opposite walls.
void FloatPlan::warnIfWider(const WaterParameters& water, const std::string& name,
                            std::size_t index) const {
  const glm::mat4 turned = rotationMatrix(floats_[index].rotation);
  glm::vec3 low(1e30F), high(-1e30F);
  for (const glm::vec3& corner : hulls_[index].corners) {
    const glm::vec3 at(turned * glm::vec4(corner, 0));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const glm::vec2 wide(high.x - low.x, high.z - low.z), basin = glm::vec2(water.size) * water.cell;
  const auto wall = [&](std::size_t side) { return water.sides[side] == WaterBorder::wall; };
  if ((wide.x <= basin.x || !(wall(0) && wall(1))) && (wide.y <= basin.y || !(wall(2) && wall(3)))) return;
  warn(
      "water \"{}\": the float is {:g} by {:g} m, wider than the basin of {:g} by {:g} m; make it smaller "
      "or the basin larger",
      name, wide.x, wide.y, basin.x, basin.y);
}

void FloatPlan::addBody(const WaterParameters& water, const std::string& name, std::size_t index,
                        double depth, const std::vector<glm::vec4>& cells) {
  const double cell = water.cell;
  const WaterFloat& body = floats_[index];
  const Hull& hull = hulls_[index];
  const double widest = std::max({hull.grain.x, hull.grain.y, hull.grain.z});
  const int reach = static_cast<int>(std::ceil(std::min((hull.reach + widest) / cell, 1e6))) + 3;
  if (reach > largestReach)
    fail(ExitCode::usage,
         "water \"{}\": the float affects {} cells of {} m on each side, and the maximum is {}; make it "
         "smaller or "
         "\"cell\" larger",
         name, reach, water.cell, largestReach);
  side_ = std::max(side_, 2 * reach + 1);
  warnIfWider(water, name, index);
  const auto inverse = hull.inverseInertia();
  const double lighter = waterDensity * hull.volume / hull.mass;
  // By Cauchy's formula, the mean projected area of a convex body is a quarter of its surface area.
  const double perLength = 0.25 * hull.area / hull.volume;
  const double followed = step_.dt / followSeconds(water, depth);
  shader::FloatParameters t{};
  const FloatShape& touched = hull.touched;
  const double around = touched.radius > 0 ? touched.radius : hull.reach;
  t.mass = four(hull.mass, 1 / hull.mass, around, hull.inertia[1]);
  t.turnA = four(inverse[0], inverse[1], inverse[2], static_cast<double>(points_.size()));
  points_.insert(points_.end(), hull.points.begin(), hull.points.end());
  t.turnB = four(inverse[3], inverse[4], inverse[5], static_cast<double>(points_.size()));
  const auto next = [&] { return static_cast<double>(points_.size()); };
  t.meet = four(next(), 0, 0, touched.radius);
  points_.insert(points_.end(), touched.probes.begin(), touched.probes.end());
  t.meet.y = t.meet.z = static_cast<float>(next());
  points_.insert(points_.end(), touched.nodes.begin(), touched.nodes.end());
  t.field = glm::vec4(glm::dvec4(touched.low, 1 / touched.step));
  t.nodes = glm::vec4(glm::dvec4(glm::dvec3(touched.counts), touched.step));
  t.grain = four(hull.grain.x, hull.grain.y, hull.grain.z, hull.volume);
  t.drag = four(body.drag * lighter, 0.5 * body.resistance * perLength * lighter, body.keel - 1.0,
                hull.mass / (hull.outline * waterDensity));
  t.reach = four(reach, std::min(0.25, followed), body.friction, 0);
  parameters_.push_back(t);
  // Computes the body's initial state.
  const glm::mat4 turned = rotationMatrix(body.rotation);
  const glm::vec3 middle = glm::vec3(turned * glm::vec4(glm::vec3(hull.middle), 0));
  const glm::dvec3 spin = glm::dvec3(body.spin) * 0.017453292519943295;
  glm::dvec3 own(0);  // The angular velocity is first converted to the body's local space, then to the
                      // angular momentum.
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row) own[axis] += static_cast<double>(turned[axis][row]) * spin[row];
  own = times(hull.inertia, own);
  glm::dvec3 momentum(0);
  for (int row = 0; row < 3; ++row)
    for (int axis = 0; axis < 3; ++axis)
      momentum[row] += static_cast<double>(turned[axis][row]) * own[axis];
  const auto held = [](double at, int count) {
    return static_cast<std::size_t>(std::clamp(std::floor(at), 0.0, count - 1.0));
  };
  const glm::vec4 under = cells.empty()
                              ? glm::vec4(0)
                              : cells[held(body.position.z / cell + 0.5 * water.size.y, water.size.y) *
                                          static_cast<std::size_t>(water.size.x) +
                                      held(body.position.x / cell + 0.5 * water.size.x, water.size.x)];
  const float level = under.x - under.w > step_.dry ? under.x : water.level;
  first_.emplace_back(body.position + middle, level);
  first_.push_back(quaternionOf(turned));
  first_.emplace_back(body.velocity, 0.0F);
  first_.emplace_back(glm::vec3(momentum), 0.0F);
  first_.emplace_back(level, level, level, 0.0F);
}

std::vector<glm::vec4> FloatPlan::parametersAt(double time) const {
  std::vector<glm::vec4> texels(parameters_.size() *
                                static_cast<std::size_t>(shader::floatParameterTexels));
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const WaterFloat& body = floats_[i];
    shader::FloatParameters t = parameters_[i];
    t.reach.w = body.thrust.at(time);
    t.head = four(0, 0, static_cast<double>(body.steering.at(time)) / hulls_[i].aside2, body.air);
    if (body.tow) {
      const glm::dvec3 from(body.tow->position.at(time));
      const glm::dvec3 speed =
          (glm::dvec3(body.tow->position.at(time + frameSeconds_)) - from) / frameSeconds_;
      t.tow = four(from.x, from.z, speed.x, speed.z);
      const double pull = body.tow->pull;
      t.pull = four(pull * pull, 2 * pull, 0, 0);
      const double along = std::sqrt(speed.x * speed.x + speed.z * speed.z);
      if (body.tow->turns && along > 1e-6) {
        t.head = four(speed.x / along, speed.z / along, t.head.z, t.head.w);
        t.pull = four(pull * pull, 2 * pull, pull * pull, 2 * pull);
      }
    }
    std::memcpy(&texels[i * static_cast<std::size_t>(shader::floatParameterTexels)], &t, sizeof t);
  }
  return texels;
}

}  // namespace simreel::sim
