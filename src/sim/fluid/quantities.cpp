#include "sim/fluid/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

/// Returns the bilinearly interpolated velocity at p (in cells); `flow` includes the ring of cells.
glm::dvec2 velocityAt(glm::ivec2 size, std::span<const glm::vec4> flow, glm::dvec2 p) {
  const auto part = [&](int which) {
    const glm::dvec2 node = p - (which == 0 ? glm::dvec2(0, 0.5) : glm::dvec2(0.5, 0));
    const glm::dvec2 held = glm::clamp(node, glm::dvec2(-1), glm::dvec2(size));
    const glm::ivec2 cell = glm::min(glm::ivec2(glm::floor(held)), size - 1);
    const glm::dvec2 way = held - glm::dvec2(cell);
    const auto value = [&](int x, int y) -> double {
      return flow[static_cast<std::size_t>(cell.y + y + 1) * static_cast<std::size_t>(size.x + 2) +
                  static_cast<std::size_t>(cell.x + x + 1)][which];
    };
    const double upper = value(0, 0) + (value(1, 0) - value(0, 0)) * way.x;
    const double lower = value(0, 1) + (value(1, 1) - value(0, 1)) * way.x;
    return upper + (lower - upper) * way.y;
  };
  return {part(0), part(1)};
}

}  // namespace

FluidForce forceOn(const FluidParameters& p, const FluidSolids& solids, double viscosity,
                   std::span<const glm::vec4> flow) {
  const double near = shader::wallReach, farther = 2 * near;
  FluidForce force;
  if (p.obstacles.empty()) return force;
  const glm::ivec2 size = p.size;
  const auto off = [&](int x, int y) {
    return solids.distanceAt(std::clamp(x, 0, size.x - 1), std::clamp(y, 0, size.y - 1));
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto cell =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      if (solids.solid()[cell] != 0 || !p.obstacles[solids.wordAt(x, y) >> 16U & 255U].measured) continue;
      const glm::dvec4 closed = solids.closedAt(x, y);
      const glm::dvec2 wall(
          closed.y - closed.x,
          closed.w -
              closed.z);  // Points into the obstacle; its length is the length of the wall in this cell.
      const double length = std::sqrt(wall.x * wall.x + wall.y * wall.y);
      if (length == 0) continue;
      const double pressure = flow[static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(size.x + 2) +
                                   static_cast<std::size_t>(x + 1)]
                                  .w;
      force.pressure += pressure * wall;
      if (p.obstaclesSlip) continue;
      const glm::dvec2 slope(off(x + 1, y) - off(x - 1, y), off(x, y + 1) - off(x, y - 1));
      const glm::dvec2 normal = slope / std::max(std::sqrt(slope.x * slope.x + slope.y * slope.y), 1e-6);
      const glm::dvec2 foot = glm::dvec2(x + 0.5, y + 0.5) - off(x, y) * normal;
      const auto past = [&](double away) {
        const glm::dvec2 point = foot + away * normal;
        return velocityAt(size, flow, point) - solids.velocityAt({x, y}, point);
      };
      const glm::dvec2 first = past(near), second = past(farther);
      const glm::dvec2 shear =
          (first * (farther * farther) - second * (near * near)) / (near * farther * (farther - near));
      force.friction += viscosity * length * shear;
    }
  return force;
}

FluidCells openCells(glm::ivec2 size, const std::vector<std::uint8_t>& solid) {
  const auto isOpen = [&](int x, int y) {
    return solid[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)] == 0;
  };
  FluidCells cells;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      if (!isOpen(x, y)) continue;
      ++cells.open;
      if (x > 0 && y > 0 && isOpen(x - 1, y) && isOpen(x, y - 1) && isOpen(x - 1, y - 1)) ++cells.corners;
    }
  return cells;
}

std::vector<double> measureFluid(const FluidPlan& plan, const FluidSolids& solids,
                                 std::span<const glm::vec4> flow, std::span<const glm::vec4> dye,
                                 const FluidPressure::Report& report, double time) {
  const glm::ivec2 size = plan.size();
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(size.x + 2) +
           static_cast<std::size_t>(x + 1);
  };
  double energy = 0, squares = 0, dyes = 0, heat = 0, speed = 0;
  long open = 0, corners = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::dvec4 here(flow[index(x, y)]);
      const glm::dvec4 color(dye[index(x, y)]);
      dyes += color.x + color.y + color.z;
      const auto solidAt = [&](int i, int j) {
        return solids.solid()[static_cast<std::size_t>(j) * static_cast<std::size_t>(size.x) +
                              static_cast<std::size_t>(i)] != 0;
      };
      if (solidAt(x, y)) continue;
      const double right = flow[index(x + 1, y)].x, below = flow[index(x, y + 1)].y;
      energy += 0.25 * (here.x * here.x + right * right + here.y * here.y + below * below);
      heat += here.z;
      ++open;
      speed = std::max({speed, std::abs(here.x), std::abs(here.y)});
      if (x == 0 || y == 0 || solidAt(x - 1, y) || solidAt(x, y - 1) || solidAt(x - 1, y - 1)) continue;
      const double curl = (here.y - flow[index(x - 1, y)].y) - (here.x - flow[index(x, y - 1)].x);
      squares += 0.5 * curl * curl;
      ++corners;
    }
  const auto each = [](double sum, long count) { return count > 0 ? sum / static_cast<double>(count) : 0; };
  const FluidParameters& p = plan.parameters();
  const glm::dvec2 force = forceOn(p, solids, p.viscosity.at(time), flow).all();
  const double dt = static_cast<double>(plan.stepAt(0, 0).dt);
  return {report.worstShare,
          each(energy, open),
          each(squares, corners),
          dyes,
          each(heat, open),
          speed,
          speed * dt,
          report.cycles,
          force.x,
          -force.y};
}

}  // namespace simreel::sim
