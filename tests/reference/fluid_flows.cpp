#include "reference/fluid_flows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

using namespace simreel;

namespace flows {

namespace {

using Side = sim::FluidSide::Kind;

/// Returns the maximum of the samples from index `first` on, refined by a parabola through three samples.
double peak(const std::vector<double>& values, std::size_t first) {
  double maximum = -1e300;
  for (std::size_t i = std::max<std::size_t>(first, 1); i + 1 < values.size(); ++i) {
    const double a = values[i - 1], b = values[i], c = values[i + 1];
    if (b < a || b < c) continue;
    const double bend = a - 2 * b + c;
    maximum = std::max(maximum, bend < 0 ? b - (c - a) * (c - a) / (8 * bend) : b);
  }
  return maximum;
}

std::size_t from(const std::vector<double>& times, double seconds) {
  return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), times.back() - seconds) -
                                  times.begin());
}

constexpr double ghiaY[] = {0.9766, 0.9688, 0.9609, 0.9531, 0.8516, 0.7344, 0.6172, 0.5,
                            0.4531, 0.2813, 0.1719, 0.1016, 0.0703, 0.0625, 0.0547};
constexpr double ghiaX[] = {0.9688, 0.9609, 0.9531, 0.9453, 0.9063, 0.8594, 0.8047, 0.5,
                            0.2344, 0.2266, 0.1563, 0.0938, 0.0781, 0.0703, 0.0625};

/// Returns the extremum of the parabola through three evenly spaced values, of which b is the middle one.
double parabolaAt(double a, double b, double c) {
  const double bend = a - 2 * b + c;
  return bend == 0 ? b : b - (c - a) * (c - a) / (8 * bend);
}

}  // namespace

double Wake::maxDrag(double seconds) const {
  return peak(drag, from(times, seconds));
}

double Wake::maxLift(double seconds) const {
  return peak(lift, from(times, seconds));
}

double Wake::meanDrag(double seconds) const {
  double sum = 0;
  const std::size_t first = from(times, seconds);
  for (std::size_t i = first; i < drag.size(); ++i) sum += drag[i];
  return sum / static_cast<double>(drag.size() - first);
}

double Wake::frequency(double seconds) const {
  const std::size_t first = from(times, seconds);
  double mean = 0;
  for (std::size_t i = first; i < lift.size(); ++i) mean += lift[i];
  mean /= static_cast<double>(lift.size() - first);
  std::vector<double> zeros;
  for (std::size_t i = first + 1; i < lift.size(); ++i) {
    const double a = lift[i - 1] - mean, b = lift[i] - mean;
    if (a < 0 && b >= 0) zeros.push_back(times[i - 1] + (times[i] - times[i - 1]) * a / (a - b));
  }
  if (zeros.size() < 2) return 0;
  return static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
}

Cylinder schaeferTurek(int n) {
  Cylinder c;
  const double metre = 10.0 * n;  // number of cells per metre
  sim::FluidParameters& p = c.parameters;
  p.size = {22 * n, static_cast<int>(std::lround(4.1 * n))};
  p.strokes.clear();
  p.left.kind = Side::inflow;
  p.left.profile = sim::FluidSide::Profile::parabola;
  p.left.velocity = glm::vec3(1.5 * metre, 0, 0);
  p.right.kind = Side::open;
  p.flow = {static_cast<float>(metre), 0, 0};
  p.speed = static_cast<float>(2.3 * metre);
  p.viscosity = static_cast<float>(1e-3 * metre * metre);
  p.advection = sim::FluidParameters::Advection::cubic;
  p.courant = 1;
  sim::FluidObstacle obstacle;
  obstacle.center = glm::vec3(0.2 * metre, 0.21 * metre, 0);
  obstacle.radius = static_cast<float>(0.05 * metre);
  p.obstacles = {obstacle};
  c.diameter = n;
  c.speed = metre;
  c.frame = 0.01;
  return c;
}

Cylinder wideChannel(int n) {
  Cylinder c;
  sim::FluidParameters& p = c.parameters;
  p.size = {28 * n, 30 * n};
  p.strokes.clear();
  p.left.kind = Side::inflow;
  p.left.velocity = glm::vec3(n, 0, 0);
  p.right.kind = Side::open;
  p.top.kind = p.bottom.kind = Side::slip;
  p.flow = {static_cast<float>(n), 0, 0};
  p.speed = static_cast<float>(1.5 * n);
  p.viscosity = static_cast<float>(0.01 * n * n);
  p.courant = 1;
  sim::FluidObstacle obstacle;
  obstacle.center = glm::vec3(9 * n, 15 * n, 0);
  obstacle.radius = 0.5F * static_cast<float>(n);
  p.obstacles = {obstacle};
  sim::FluidStroke kick;
  kick.at = 0.1;
  kick.until = 3;
  kick.from = kick.to = {10.5F * static_cast<float>(n), 15.0F * static_cast<float>(n), 0};
  kick.radius = 0.8F * static_cast<float>(n);
  kick.force = glm::vec3(0, 0.6F * static_cast<float>(n), 0);
  p.strokes = {kick};
  c.diameter = n;
  c.speed = n;
  c.frame = 0.25;
  return c;
}

void note(Wake& wake, const Cylinder& cylinder, double time, std::span<const double> quantities) {
  const double per = 2 / (cylinder.speed * cylinder.speed * cylinder.diameter);
  wake.times.push_back(time);
  wake.drag.push_back(quantities[8] * per);
  wake.lift.push_back(quantities[9] * per);
}

sim::FluidParameters cavity(int n, double reynolds) {
  sim::FluidParameters p;
  p.size = {n, n};
  p.strokes.clear();
  p.top.velocity = glm::vec3(n, 0, 0);
  p.speed = static_cast<float>(n);
  p.viscosity = static_cast<float>(n * n / reynolds);
  p.courant = 0.8F;
  return p;
}

const Ghia& ghia(double reynolds) {
  static const Ghia tables[] = {{100,
                                 {0.84123, 0.78871, 0.73722, 0.68717, 0.23151, 0.00332, -0.13641, -0.20581,
                                  -0.21090, -0.15662, -0.10150, -0.06434, -0.04775, -0.04192, -0.03717},
                                 {-0.05906, -0.07391, -0.08864, -0.10313, -0.16914, -0.22445, -0.24533,
                                  0.05454, 0.17527, 0.17507, 0.16077, 0.12317, 0.10890, 0.10091, 0.09233}},
                                {400,
                                 {0.75837, 0.68439, 0.61756, 0.55892, 0.29093, 0.16256, 0.02135, -0.11477,
                                  -0.17119, -0.32726, -0.24299, -0.14612, -0.10338, -0.09266, -0.08186},
                                 {-0.12146, -0.15663, -0.19254, -0.22847, -0.23827, -0.44993, -0.38598,
                                  0.05186, 0.30174, 0.30203, 0.28124, 0.22965, 0.20920, 0.19713, 0.18360}},
                                {1000,
                                 {0.65928, 0.57492, 0.51117, 0.46604, 0.33304, 0.18719, 0.05702, -0.06080,
                                  -0.10648, -0.27805, -0.38289, -0.29730, -0.22220, -0.20196, -0.18109},
                                 {-0.21388, -0.27669, -0.33714, -0.39188, -0.51550, -0.42665, -0.31966,
                                  0.02526, 0.32235, 0.33075, 0.37095, 0.32627, 0.30353, 0.29012, 0.27485}}};
  for (const Ghia& table : tables)
    if (table.reynolds == reynolds) return table;
  throw std::invalid_argument("no table of this Reynolds number");
}

double ghiaError(const Ghia& table, int n, std::span<const glm::vec4> flow, std::vector<double>* where) {
  const auto cell = [&](int x, int y) {
    return flow[static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(n + 2) +
                static_cast<std::size_t>(x + 1)];
  };
  // Interpolates linearly between nodes. Nodes half a cell outside the walls have the values for which the
  // interpolated speed at the wall equals the speed of the wall.
  const auto between = [&](double place, const auto& node) {
    const int i = static_cast<int>(std::floor(place));
    return node(i) + (node(i + 1) - node(i)) * (place - i);
  };
  std::vector<double> differences;
  for (std::size_t i = 0; i < 15; ++i) {
    const double u = between((1 - ghiaY[i]) * n - 0.5, [&](int y) -> double { return cell(n / 2, y).x; });
    differences.push_back(u / n - table.u[i]);
  }
  for (std::size_t i = 0; i < 15; ++i) {
    const double v = between(ghiaX[i] * n - 0.5, [&](int x) -> double { return -cell(x, n / 2).y; });
    const bool misprint = table.reynolds == 400 && ghiaX[i] == 0.9063;
    differences.push_back(misprint ? 0 : v / n - table.v[i]);
  }
  double worst = 0;
  for (const double d : differences) worst = std::max(worst, std::abs(d));
  if (where != nullptr) *where = differences;
  return worst;
}

Extremes extremesOf(int n, std::span<const glm::vec4> flow) {
  const auto cell = [&](int x, int y) {
    return flow[static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(n + 2) +
                static_cast<std::size_t>(x + 1)];
  };
  std::vector<double> u, v;
  for (int i = 0; i < n; ++i) {
    u.push_back(cell(n / 2, i).x / static_cast<double>(n));
    v.push_back(-cell(i, n / 2).y / static_cast<double>(n));
  }
  const auto extreme = [](const std::vector<double>& of, double sign) {
    std::size_t best = 1;
    for (std::size_t i = 1; i + 1 < of.size(); ++i)
      if (sign * of[i] > sign * of[best]) best = i;
    return parabolaAt(of[best - 1], of[best], of[best + 1]);
  };
  return {extreme(u, -1), extreme(v, 1), extreme(v, -1)};
}

}  // namespace flows
