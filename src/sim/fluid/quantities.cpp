#include "sim/fluid/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

FluidCells openCells(const FluidPlan& plan) {
  const glm::ivec2 size = plan.size();
  const auto isOpen = [&](int x, int y) {
    return plan.solid()[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
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

std::vector<double> measureFluid(const FluidPlan& plan, std::span<const glm::vec4> flow,
                                 std::span<const glm::vec4> dye, const FluidPressure::Report& report) {
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
        return plan.solid()[static_cast<std::size_t>(j) * static_cast<std::size_t>(size.x) +
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
  const double dt = static_cast<double>(plan.stepAt(0, 0).dt);
  return {report.worstShare, each(energy, open), each(squares, corners), dyes, each(heat, open), speed,
          speed * dt,        report.cycles};
}

}  // namespace simreel::sim
