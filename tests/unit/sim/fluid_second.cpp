// Tests one step of each fluid kernel by comparison with an independent implementation of its equations in
// double precision. The implementation represents u and v as functions of the position between walls,
// without arrays and border rings.
#include "reference/fluid_twin.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

using Plane = std::function<double(int, int)>;

/// Flow between no-slip walls, of which the top one moves.
struct Walled {
  int w, h;
  double lid;
  Plane inU, inV;  ///< velocities at the faces inside the grid

  [[nodiscard]] double u(int x, int y) const {
    if (y < 0) return 2 * lid - u(x, 0);
    if (y >= h) return -u(x, h - 1);
    return inU(std::clamp(x, 0, w), y);
  }
  [[nodiscard]] double v(int x, int y) const {
    if (x < 0) return -v(0, y);
    if (x >= w) return -v(w - 1, y);
    return inV(x, std::clamp(y, 0, h));
  }
};

struct Spot {
  double x, y;
};

double bilinear(const std::function<double(int, int)>& node, double x, double y) {
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const double s = x - i, t = y - j;
  return (1 - s) * (1 - t) * node(i, j) + s * (1 - t) * node(i + 1, j) + (1 - s) * t * node(i, j + 1) +
         s * t * node(i + 1, j + 1);
}

Spot velocity(const Walled& f, Spot p) {
  return {bilinear([&](int x, int y) { return f.u(x, y); }, p.x, p.y - 0.5),
          bilinear([&](int x, int y) { return f.v(x, y); }, p.x - 0.5, p.y)};
}

Spot heldSpot(const Walled& f, Spot p) {
  return {std::clamp(p.x, 0.0, double(f.w)), std::clamp(p.y, 0.0, double(f.h))};
}

Spot wentTo(const Walled& f, Spot p, double dt) {
  const Spot v = velocity(f, p);
  return heldSpot(f, {p.x + v.x * dt, p.y + v.y * dt});
}

/// Returns the departure point of the fluid at p, using the velocity at the midpoint of its path.
Spot cameFrom(const Walled& f, Spot p, double dt) {
  const Spot v = velocity(f, wentTo(f, p, -dt));
  return heldSpot(f, {p.x - v.x * dt, p.y - v.y * dt});
}

/// Returns the second difference along a line of `count` nodes. A wall with a given speed is half a node
/// beyond each end. At the ends, the parabola through the wall and two nodes is used.
double bend(const std::function<double(int)>& node, int i, int count, double first, double last) {
  if (i == 0) return 8.0 / 3 * first - 4 * node(0) + 4.0 / 3 * node(1);
  if (i == count - 1) return 8.0 / 3 * last - 4 * node(i) + 4.0 / 3 * node(i - 1);
  return node(i - 1) - 2 * node(i) + node(i + 1);
}

double friction(const Walled& f, bool alongX, int x, int y) {
  if (alongX)
    return f.u(x - 1, y) - 2 * f.u(x, y) + f.u(x + 1, y) +
           bend([&](int j) { return f.u(x, j); }, y, f.h, f.lid, 0);
  return f.v(x, y - 1) - 2 * f.v(x, y) + f.v(x, y + 1) +
         bend([&](int i) { return f.v(i, y); }, x, f.w, 0, 0);
}

/// Returns the result of MacCormack advection with its limiter, for u if `alongX` is true and for v
/// otherwise. `ahead`: the flow after one plain advection.
double macCormack(const Walled& f, const Walled& ahead, bool alongX, int x, int y, double dt) {
  const Spot place = alongX ? Spot{double(x), y + 0.5} : Spot{x + 0.5, double(y)};
  const auto sample = [&](const Walled& of, Spot p) {
    return alongX ? velocity(of, p).x : velocity(of, p).y;
  };
  const auto node = [&](const Walled& of, int i, int j) { return alongX ? of.u(i, j) : of.v(i, j); };
  const Spot from = cameFrom(f, place, dt);
  const double value = node(ahead, x, y) + (node(f, x, y) - sample(ahead, wentTo(f, place, dt))) / 2;
  const int i = static_cast<int>(std::floor(alongX ? from.x : from.x - 0.5));
  const int j = static_cast<int>(std::floor(alongX ? from.y - 0.5 : from.y));
  const auto corners = {node(f, i, j), node(f, i + 1, j), node(f, i, j + 1), node(f, i + 1, j + 1)};
  return std::clamp(value, std::min(corners), std::max(corners));
}

sim::FluidParameters walledBath(int w, int h) {
  sim::FluidParameters p;
  p.size = {w, h};
  p.substeps = 1;
  p.top.velocity = glm::vec3(9, 0, 0);
  p.speed = 100;
  sim::FluidStroke jet;
  jet.from = jet.to = {0.4F * static_cast<float>(w), 0.5F * static_cast<float>(h), 0};
  jet.until = 1;
  jet.radius = 4;
  jet.setsVelocity = jet.setsDye = jet.setsTemperature = true;
  jet.velocity = glm::vec3(45, 25, 0);
  jet.temperature = 1.5F;
  jet.dye = glm::vec3(1, 0.5F, 0.25F);
  p.strokes = {jet};
  return p;
}

/// Returns the twin's flow as functions of position.
Walled walled(const FluidTwin& twin, const std::vector<glm::vec4>& flow, double lid) {
  return {twin.plan().size().x, twin.plan().size().y, lid,
          [&](int x, int y) -> double { return flow[twin.index(x, y)].x; },
          [&](int x, int y) -> double { return flow[twin.index(x, y)].y; }};
}

}  // namespace

TEST_CASE(
    "fluid: advection, friction, pressure, lift and confinement equal their equations in double "
    "precision") {
  auto p = walledBath(27, 21);
  p.viscosity = 1.3F;
  p.confinement = 6.0F;
  p.speed = 60;
  p.lift = 40.0F;
  p.cooling = 2;
  p.dyeWeight = 25.0F;
  const double dt = 0.02;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, dt));
  for (int i = 0; i < 6; ++i) twin.step(i * dt);
  const std::vector<glm::vec4> flow = twin.flow;
  const Walled start = walled(twin, flow, 9);
  const int w = p.size.x, h = p.size.y;
  const auto inside = [&](int across, int along, int end) {
    return along > 0 && along < end && across >= 0;
  };
  const auto curl = [&](int x, int y) {
    return start.v(x, y) - start.v(x - 1, y) - start.u(x, y) + start.u(x, y - 1);
  };
  int lessened = 0;
  // Returns vorticity confinement epsilon (N x omega) with N = grad |omega| / |grad |omega|| at a face. a
  // and b are the vorticities of the face's corners. `before` and `after` are the vorticities of the
  // neighbouring corners across the face. The result is reduced above half of the expected speed.
  const auto confined = [&](double a, double b, double before, double after, int x, int y) {
    const double along = std::abs(b) - std::abs(a), across = (after - before) / 2;
    const double fastest = std::max(std::abs(start.u(x, y)), std::abs(start.v(x, y)));
    const double share = std::clamp(2 - 2 * fastest / static_cast<double>(p.speed), 0.0, 1.0);
    lessened += share > 0 && share < 1 ? 1 : 0;
    return 6 * share * (a + b) / 2 * along / std::sqrt(std::max(along * along + across * across, 1e-12));
  };
  const auto pressure = [&](int x, int y) -> double { return flow[twin.index(x, y)].w; };
  const auto heat = [&](int x, int y) -> double {
    return flow[twin.index(std::clamp(x, 0, w - 1), std::clamp(y, 0, h - 1))].z;
  };
  // `f` is the flow after half of the forces, including confinement.
  Walled f = start;
  f.inU = [&](int x, int y) {
    if (!inside(y, x, w)) return start.u(x, y);
    const auto mean = [&](int i) { return (std::abs(curl(i, y)) + std::abs(curl(i, y + 1))) / 2; };
    const double half = (1.3 * friction(start, true, x, y) - (pressure(x, y) - pressure(x - 1, y))) / 2;
    return start.u(x, y) +
           dt * (half + confined(curl(x, y), curl(x, y + 1), mean(x - 1), mean(x + 1), x, y));
  };
  f.inV = [&](int x, int y) {
    if (!inside(x, y, h)) return start.v(x, y);
    const auto mean = [&](int j) { return (std::abs(curl(x, j)) + std::abs(curl(x + 1, j))) / 2; };
    const double rise = 40 * (heat(x, y) + heat(x, y - 1)) / 2;
    const double half =
        (1.3 * friction(start, false, x, y) - (pressure(x, y) - pressure(x, y - 1)) - rise) / 2;
    return start.v(x, y) +
           dt * (half - confined(curl(x, y), curl(x + 1, y), mean(y - 1), mean(y + 1), x, y));
  };
  // The values are cached, because later stages read them many times.
  const auto kept = [&](const Plane& of) {
    auto values = std::make_shared<std::vector<double>>();
    for (int y = 0; y <= h; ++y)
      for (int x = 0; x <= w; ++x) values->push_back(of(x, y));
    return [values, w](int x, int y) { return (*values)[static_cast<std::size_t>(y * (w + 1) + x)]; };
  };
  const Walled lazy = f;
  f.inU = kept([&](int x, int y) { return y < h ? lazy.u(x, y) : 0; });
  f.inV = kept([&](int x, int y) { return x < w ? lazy.v(x, y) : 0; });
  Walled ahead = f;
  ahead.inU = kept([&](int x, int y) {
    if (y == h) return 0.0;
    return inside(y, x, w) ? velocity(f, cameFrom(f, {double(x), y + 0.5}, dt)).x : f.u(x, y);
  });
  ahead.inV = kept([&](int x, int y) {
    if (x == w) return 0.0;
    return inside(x, y, h) ? velocity(f, cameFrom(f, {x + 0.5, double(y)}, dt)).y : f.v(x, y);
  });
  const Plane carriedHeat = kept([&](int x, int y) {
    const Spot from = cameFrom(f, {x + 0.5, y + 0.5}, dt);
    return bilinear(heat, from.x - 0.5, from.y - 0.5);
  });
  const auto density = [&](int x, int y) -> double {
    const glm::vec4 c = twin.dye[twin.index(x, y)];
    return c.x / 3.0 + c.y / 3.0 + c.z / 3.0;
  };
  twin.setStep(twin.plan().stepAt(6 * dt, 1));
  twin.advect();
  double worstU = 0, worstV = 0, maximum = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      if (x > 0) {
        const double half = (1.3 * friction(ahead, true, x, y) - (pressure(x, y) - pressure(x - 1, y))) / 2;
        const double want = macCormack(f, ahead, true, x, y, dt) + dt * half;
        worstU = std::max(worstU, std::abs(want - twin.flow[twin.index(x, y)].x));
        maximum = std::max(maximum, std::abs(want));
      }
      if (y > 0) {
        const double rise = 40 * (carriedHeat(x, y) + carriedHeat(x, y - 1)) / 2;
        const double fall = 25 * (density(x, y) + density(x, y - 1)) / 2;
        const double half =
            (1.3 * friction(ahead, false, x, y) - (pressure(x, y) - pressure(x, y - 1)) - rise) / 2;
        const double want = macCormack(f, ahead, false, x, y, dt) + dt * (half + fall);
        worstV = std::max(worstV, std::abs(want - twin.flow[twin.index(x, y)].y));
      }
    }
  CHECK(lessened > 20);
  CHECK(maximum > 20);
  CHECK(worstU < 3e-4);
  CHECK(worstV < 3e-4);
}

TEST_CASE("fluid: air that enters through an open side has the temperature 0") {
  auto p = walledBath(12, 10);
  p.top.kind = sim::FluidSide::Kind::open;
  p.lift = 40.0F;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, 0.02));
  for (glm::vec4& cell : twin.flow) cell = glm::vec4(0, 0, 1, 0);
  twin.setStep(twin.plan().stepAt(0, 1));
  twin.advect();
  twin.paint(0, 1);
  twin.project();
  CHECK(twin.flow[twin.index(5, -1)].z == 0);
  CHECK(twin.flow[twin.index(5, 10)].z > 0.9F);  // a wall conducts no heat
}

TEST_CASE("fluid: the projection equals a dense Poisson solution, around obstacles and with an open side") {
  auto p = walledBath(19, 14);
  p.right.kind = sim::FluidSide::Kind::open;
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(12, 6, 0);
  p.obstacles[0].radius = 2.5F;
  const int w = p.size.x, h = p.size.y;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, 0.02));
  twin.setStep(twin.plan().stepAt(0, 1));
  twin.advect();
  twin.paint(0, 1);
  const std::vector<glm::vec4> before = twin.flow;
  twin.project();
  // Returns the fraction of a face outside the circle. It is computed from the distances of the face's ends
  // to the circle, with a chord instead of the arc.
  const auto off = [](double x, double y) {
    return std::sqrt((x - 12) * (x - 12) + (y - 6) * (y - 6)) - 2.5;
  };
  const auto share = [](double a, double b) {
    const double part = a > 0 && b > 0 ? 1 : a <= 0 && b <= 0 ? 0 : std::max(a, b) / std::abs(a - b);
    return part < 0.0625 ? 0 : part;
  };
  const auto openX = [&](int x, int y) { return x == 0 ? 0 : share(off(x, y), off(x, y + 1)); };
  const auto openY = [&](int x, int y) { return y == 0 || y == h ? 0 : share(off(x, y), off(x + 1, y)); };
  // The expected pressure is computed by successive over-relaxation in double precision. At the open side,
  // phi = 0 half a cell outside.
  std::vector<double> phi(static_cast<std::size_t>(w * h));
  const auto at = [&](int x, int y) -> double& { return phi[static_cast<std::size_t>(y * w + x)]; };
  const auto flowAt = [&](int x, int y) { return glm::dvec4(before[twin.index(x, y)]); };
  int cut = 0;
  for (int sweep = 0; sweep < 4000; ++sweep)
    for (int y = 0; y < h; ++y)
      for (int x = 0; x < w; ++x) {
        const double left = openX(x, y), right = openX(x + 1, y), top = openY(x, y),
                     bottom = openY(x, y + 1);
        const double weights = left + (x + 1 == w ? 2 * right : right) + top + bottom;
        if (weights == 0) continue;
        if (sweep == 0 && (left + right + top + bottom) < 4 && off(x + 0.5, y + 0.5) < 1) ++cut;
        const double sum = (left > 0 ? left * at(x - 1, y) : 0) +
                           (right > 0 && x + 1 < w ? right * at(x + 1, y) : 0) +
                           (top > 0 ? top * at(x, y - 1) : 0) + (bottom > 0 ? bottom * at(x, y + 1) : 0);
        const double out = right * flowAt(x + 1, y).x - left * flowAt(x, y).x +
                           bottom * flowAt(x, y + 1).y - top * flowAt(x, y).y;
        at(x, y) += 1.6 * ((sum - out) / weights - at(x, y));
      }
  double worst = 0, change = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 1; x <= w; ++x) {
      if (openX(x, y) == 0) continue;
      const double push = x == w ? -2 * at(x - 1, y) : at(x, y) - at(x - 1, y);
      worst = std::max(worst, std::abs(flowAt(x, y).x - push - twin.flow[twin.index(x, y)].x));
      change = std::max(change, std::abs(push));
    }
  CHECK(cut > 12);
  CHECK(change > 5);
  CHECK(worst < 2e-3);
  CHECK(twin.divergence() < sim::maxFluidDivergence);
}

TEST_CASE("fluid: dye transport equals van Leer's scheme in double precision") {
  auto p = walledBath(23, 17);
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, 0.002));
  for (int i = 0; i < 30; ++i) twin.step(i * 0.002);
  const std::vector<glm::vec4> dye = twin.dye;
  REQUIRE(twin.plan().dyePasses() == 1);
  const double dt = 0.002;
  const int w = p.size.x, h = p.size.y;
  const auto q = [&](int x, int y) -> double {
    return dye[twin.index(std::clamp(x, 0, w - 1), std::clamp(y, 0, h - 1))].x;
  };
  // Returns the flux from the values in the upwind cell, the donor cell and the downwind cell of the face.
  const auto flux = [](double way, double up, double here, double down) {
    const double a = here - up, b = down - here;
    const double slope =
        a * b <= 0 ? 0
                   : std::copysign(std::min({2 * std::abs(a), 2 * std::abs(b), std::abs(a + b) / 2}), a);
    return std::abs(way) * (here + slope * (1 - std::abs(way)) / 2);
  };
  const auto acrossLeft = [&](int x, int y) {
    const double way = std::clamp(dt * twin.flow[twin.index(x, y)].x, -0.25, 0.25);
    return way > 0 ? flux(way, q(x - 2, y), q(x - 1, y), q(x, y))
                   : -flux(way, q(x + 1, y), q(x, y), q(x - 1, y));
  };
  const auto acrossTop = [&](int x, int y) {
    const double way = std::clamp(dt * twin.flow[twin.index(x, y)].y, -0.25, 0.25);
    return way > 0 ? flux(way, q(x, y - 2), q(x, y - 1), q(x, y))
                   : -flux(way, q(x, y + 1), q(x, y), q(x, y - 1));
  };
  twin.setStep(twin.plan().stepAt(0.06, 1));
  twin.moveDye();
  double worst = 0, change = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const double want =
          q(x, y) + acrossLeft(x, y) - acrossLeft(x + 1, y) + acrossTop(x, y) - acrossTop(x, y + 1);
      worst = std::max(worst, std::abs(want - twin.dye[twin.index(x, y)].x));
      change = std::max(change, std::abs(want - q(x, y)));
    }
  CHECK(change > 0.02);
  CHECK(worst < 6e-6);  // Four faces are each rounded down to a multiple of 2^-20.
}
