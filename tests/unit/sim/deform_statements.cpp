// Tests every displacement by comparison with an independent implementation of its equation in double
// precision. This is needed because the twin compiles the shaders and would repeat their errors. The points
// include some that need special handling: on an axis, below a base, and next to a trail.
#include "sim/mesh/deform_cpu.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

using namespace simreel;
using glm::dvec2;
using glm::dvec3;

namespace {

/// Returns points around the origin, the origin itself, and a distant point.
sim::Mesh cloud() {
  sim::Mesh mesh;
  for (int i = 0; i < 400; ++i) {
    const float t = static_cast<float>(i);
    mesh.positions.emplace_back(1.7F * std::sin(2.1F * t), 1.3F * std::sin(3.7F * t + 1),
                                1.9F * std::cos(1.3F * t));
  }
  mesh.positions.emplace_back(0);
  mesh.positions.emplace_back(9, -7, 8);
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 1, 0));
  return mesh;
}

shader::DeformStep stepOf(const std::vector<int>& kinds) {
  shader::DeformStep step{};
  step.trail.cells = {2, 2};
  step.displacementCount = static_cast<int>(kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) step.displacements[i].kind = kinds[i];
  return step;
}

/// Returns the maximum distance between the twin's displaced points and `expected`.
double maxDistance(const shader::DeformStep& step, const std::function<dvec3(dvec3 rest)>& expected,
                   const std::vector<glm::vec4>& trail = {}) {
  const sim::Mesh mesh = cloud();
  const sim::RestMesh rest("cloud", mesh);
  sim::DeformCpu cpu(rest, step.trail.cells);
  if (!trail.empty()) cpu.setTrail(trail);
  cpu.displace(step, sim::Threads::one);
  double worst = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double distance = glm::length(dvec3(cpu.positions()[i]) - expected(mesh.positions[i]));
    worst = distance <= worst ? worst : distance;  // This form keeps a NaN, unlike std::max.
  }
  return worst;
}

double rippleAt(dvec3 rest, dvec3 centre, double amplitude, double decay, double wavenumber, double phase) {
  const double r = glm::length(rest - centre);
  return amplitude * std::exp(-decay * r) * std::sin(phase - wavenumber * r);
}

dvec3 nearestOn(dvec3 a, dvec3 b, dvec3 p) {
  const dvec3 axis = b - a;
  const double length2 = glm::dot(axis, axis);
  return a + axis * (length2 > 0 ? std::clamp(glm::dot(p - a, axis) / length2, 0.0, 1.0) : 0.0);
}

shader::Presser presserOf(glm::vec3 a, glm::vec3 b, float radius) {
  shader::Presser s{};
  s.start = glm::vec4(a, 0);
  s.end = glm::vec4(b, 0);
  s.radius = radius;
  const glm::vec3 axis = b - a;
  const float flat2 = axis.x * axis.x + axis.z * axis.z;
  if (a != b) s.perLength2 = 1 / glm::dot(axis, axis);
  if (flat2 > 0) s.perFlat2 = 1 / flat2;
  return s;
}

}  // namespace

TEST_CASE("deform: a ripple decays with the radius as e^(-decay r), and does not without decay") {
  for (const float decay : {0.0F, 0.8F}) {
    shader::DeformStep step = stepOf({shader::rippleKind});
    step.displacements[0].ripple = {{0.3F, 0.2F, -0.4F, 0}, 0.3F, decay, 5.0F, 2.2F};
    CHECK(maxDistance(step, [&](dvec3 p) {
            p.y += rippleAt(p, {0.3, 0.2, -0.4}, 0.3, decay, 5, 2.2);
            return p;
          }) < 3e-6);
  }
}

TEST_CASE("deform: each displacement is computed from the rest shape, and displacements add up") {
  shader::DeformStep step = stepOf({shader::waveKind, shader::rippleKind, shader::waveKind});
  const dvec2 heading(0.6, -0.8);
  step.displacements[0].wave = {heading, 0.12F, 0.09F, 3.0F, 0.7F};
  step.displacements[1].ripple = {glm::vec4(0), 0.2F, 0.5F, 4.0F, 1.0F};
  step.displacements[2].wave = {{1, 0}, 0.05F, 0.04F, 7.0F, 2.0F};
  CHECK(maxDistance(step, [&](dvec3 p) {
          const double first = 3 * (heading.x * p.x + heading.y * p.z) - 0.7, second = 7 * p.x - 2;
          dvec3 moved = p + dvec3(heading.x * 0.09 * std::cos(first), 0.12 * std::sin(first),
                                  heading.y * 0.09 * std::cos(first));
          moved += dvec3(0.04 * std::cos(second), 0.05 * std::sin(second), 0);
          moved.y += rippleAt(p, {}, 0.2, 0.5, 4, 1);
          return moved;
        }) < 5e-6);
}

TEST_CASE("deform: sway grows with height squared and lowers the tip; parts below its base do not move") {
  shader::DeformStep step = stepOf({shader::swayKind});
  const dvec2 heading(0.8, 0.6);
  step.displacements[0].sway = {heading, 0.3F, -0.2F, 1 / 1.5F, 0.4F, 0.6F, 2.0F, {0.3F, 1.1F, 2.9F, 0}};
  int still = 0;
  CHECK(maxDistance(step, [&](dvec3 p) {
          const double h = (p.y + 0.2) / 1.5;
          still += h <= 0 ? 1 : 0;
          if (h <= 0) return p;
          const double along = 2 * (p.x * heading.x + p.z * heading.y);
          const double across = 2 * (p.z * heading.x - p.x * heading.y);
          const double gust = 0.55 * std::sin(along + 0.37 * across - 0.3) +
                              0.3 * std::sin(2.3 * along - 1.7 * across - 1.1) +
                              0.15 * std::sin(7.9 * along + 9.1 * across - 2.9);
          const double lean = 0.3 * h * h * (0.4 + 0.6 * gust);
          return p + dvec3(heading.x * lean, -lean * lean / (2 * 1.5 * h), heading.y * lean);
        }) < 3e-5);
  CHECK(still > 100);
  step.displacements[0].sway.base = 20;
  CHECK(maxDistance(step, [](dvec3 p) { return p; }) == 0);
}

TEST_CASE(
    "deform: push moves vertices from r to R + r s / (R + s) away from the axis, or, if rooted, from t to "
    "e + t (f - e) / f away from the top, by a part that grows with the height") {
  for (const float perHeight : {0.0F, 0.9F}) {
    shader::DeformStep step = stepOf({shader::pushKind});
    step.displacements[0].push.softness = 0.3F;
    step.displacements[0].push.base = -0.5F;
    step.displacements[0].push.perHeight = perHeight;
    step.presserCount = 2;
    // The axis of the first presser contains the origin, which is a point of the cloud.
    step.pressers[0] = presserOf({-0.8F, 0, 0}, {0.8F, 0, 0}, 0.5F);
    step.pressers[1] = presserOf({0, 1, 1}, {0, 1, 1}, 0.6F);
    int moved = 0;
    CHECK(maxDistance(step, [&](dvec3 rest) {
            const double weight =
                perHeight > 0 ? std::clamp((rest.y + 0.5) * double{perHeight}, 0.0, 1.0) : 1.0;
            dvec3 p = rest;
            for (int i = 0; i < 2; ++i) {
              const shader::Presser& s = step.pressers[i];
              const dvec3 middle = nearestOn(dvec3(s.start), dvec3(s.end), p);
              const double radius = double{s.radius}, reach = radius + double{0.3F};
              if ((p == middle && perHeight == 0) || glm::length(p - middle) >= reach) continue;
              // The axis of the first presser is horizontal, and the second presser is a ball.
              const dvec3 top = middle + dvec3(0, perHeight > 0 ? radius : 0.0, 0);
              const double t = glm::length(p - top);
              const dvec3 along = (p - top) / t;
              const auto exitOf = [&](double around) {
                const double b = glm::dot(along, top - middle);
                return std::sqrt(b * b + around * around - glm::dot(top - middle, top - middle)) - b;
              };
              const double e = exitOf(radius), f = exitOf(reach);
              p += along * (e + t * (f - e) / f - t) * weight;
              ++moved;
            }
            return p;
          }) < 5e-6);
    CHECK(moved > 30);
  }
}

TEST_CASE(
    "deform: a footprint lowers the surface by its depth, interpolated between cells and clamped at the "
    "trail's border") {
  shader::DeformStep step = stepOf({shader::footprintsKind});
  const glm::ivec2 cells(7, 5);
  step.trail.cells = cells;
  step.trail.corner = {-1.5F, -1.2F};
  step.trail.cellSize = {0.5F, 0.6F};
  step.trail.perCell = {2.0F, 1 / 0.6F};
  std::vector<glm::vec4> trail;
  for (int i = 0; i < 35; ++i)
    trail.emplace_back(0.1F + 0.1F * std::sin(1.3F * static_cast<float>(i)),
                       0.2F + 0.2F * std::sin(2.9F * static_cast<float>(i)), 0, 0);
  int raised = 0;
  CHECK(maxDistance(
            step,
            [&](dvec3 p) {
              const double x = std::clamp((p.x + 1.5) / 0.5, 0.0, 6.0),
                           z = std::clamp((p.z + 1.2) / 0.6, 0.0, 4.0);
              dvec2 sum(0);
              for (int row = 0; row < cells.y; ++row)
                for (int column = 0; column < cells.x; ++column)
                  sum += dvec2(trail[static_cast<std::size_t>(row * cells.x + column)]) *
                         std::max(1 - std::abs(x - column), 0.0) * std::max(1 - std::abs(z - row), 0.0);
              const double rim = sum.y - 0.5 * sum.x;
              raised += rim > 0 ? 1 : 0;
              return p + dvec3(0, std::max(rim, 0.0) - sum.x, 0);
            },
            trail) < 3e-6);
  CHECK((raised > 20 && raised < 380));
}

TEST_CASE("deform: footprints are as deep as the presser, have decaying rims and persist") {
  shader::DeformStep step = stepOf({});
  const glm::ivec2 cells(41, 33);
  step.trail.cells = cells;
  step.trail.corner = {-2, -1.6F};
  step.trail.cellSize = {0.1F, 0.1F};
  step.trail.height = 0.1F;
  step.trail.depth = 0.25F;
  step.trail.rim = 0.4F;
  step.trail.perRimWidth = 4;
  step.presserCount = 4;
  // This sphere penetrates the surface by 0.15.
  step.pressers[0] = presserOf({-1, 0.35F, -1}, {-1, 0.35F, -1}, 0.4F);
  // This sphere has its centre below the surface.
  step.pressers[1] = presserOf({1, -0.2F, 0.5F}, {1, -0.2F, 0.5F}, 0.515F);
  step.pressers[2] =
      presserOf({-1, 0.5F, 0.8F}, {0.4F, 0.1F, 1.2F}, 0.3F);  // This capsule penetrates the surface.
  step.pressers[3] = presserOf({0.5F, 1.5F, -1}, {0.5F, 0.3F, -1}, 0.25F);  // This capsule is vertical.
  const sim::Mesh mesh = cloud();
  const sim::RestMesh rest("cloud", mesh);
  sim::DeformCpu cpu(rest, cells);
  std::vector<glm::vec4> before(static_cast<std::size_t>(cells.x * cells.y), glm::vec4(0));
  for (std::size_t i = 0; i < before.size(); i += 5) before[i] = {0.2F, 0.03F, 0, 0};
  cpu.setTrail(before);
  cpu.press(step, sim::Threads::one);
  double worst = 0;
  int deep = 0;
  for (int row = 0; row < cells.y; ++row)
    for (int column = 0; column < cells.x; ++column) {
      const auto i = static_cast<std::size_t>(row * cells.x + column);
      dvec2 wanted(before[i]);
      const dvec3 place(-2 + 0.1 * column, 0, -1.6 + 0.1 * row);
      for (int k = 0; k < step.presserCount; ++k) {
        const dvec3 a(step.pressers[k].start), b(step.pressers[k].end);
        const double radius = double{step.pressers[k].radius};
        const dvec3 flat = nearestOn({a.x, 0, a.z}, {b.x, 0, b.z}, place);
        const double run = glm::length(dvec2(b.x - a.x, b.z - a.z));
        const double t = run > 0 ? glm::length(flat - dvec3(a.x, 0, a.z)) / run : 0;
        const double aside = glm::length(place - flat), below = 0.1 - (a.y + t * (b.y - a.y));
        if (aside < radius) {
          wanted.x = std::max(wanted.x, std::min(below + std::sqrt(radius * radius - aside * aside), 0.25));
          deep += 1;
        }
        const double edge = below > 0 ? radius : std::sqrt(std::max(radius * radius - below * below, 0.0));
        const double beside = 4 * std::max(aside - edge, 0.0);
        wanted.y = std::max(wanted.y, 0.4 * std::exp(-beside * beside) * std::min(below + radius, 0.25));
      }
      worst = std::max(worst, glm::length(dvec2(cpu.trail()[i]) - wanted));
    }
  CHECK(worst < 2e-5);
  CHECK(deep > 100);
}
