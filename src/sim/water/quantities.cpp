#include "sim/water/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

constexpr double density = 1000;  ///< kg/m^3

}  // namespace

std::span<const scene::Quantity> WaterParameters::quantities() const {
  static constexpr scene::Quantity list[] = {
      {"volume", "m^3", "Of all water."},
      {"kineticEnergy", "J", "Of all water, at 1000 kg/m^3."},
      {"potentialEnergy", "J", "Of all water over level 0."},
      {"courant", "", "Greatest (|u| + sqrt(g h)) dt / cell along an axis."},
      {"fastest", "m/s", "Greatest speed; of what is thinner than 1/10,000 of the greatest depth none."},
      {"deepest", "m", "Greatest depth."},
      {"wetArea", "m^2", "Of cells with more than 1/200 of the greatest depth."},
      {"highestLevel", "m", "Of the water there."},
      {"lowestLevel", "m", "Of the water there; both 0 where all is dry."}};
  return list;
}

glm::vec4 waterSumFactors(const WaterParameters& parameters) {
  const double area = static_cast<double>(parameters.cell) * parameters.cell;
  const double weight = area * density;
  return {area, weight, weight * parameters.gravity, area};
}

std::vector<double> measureWater(const WaterPlan& plan, std::span<const glm::vec4> cells) {
  const WaterParameters& p = plan.parameters();
  const shader::WaterStep step = plan.stepAt(0);
  const double area = static_cast<double>(p.cell) * p.cell;
  const double ratio = plan.stepSeconds() / p.cell;
  const double shallow = plan.look().shallow;
  double volume = 0, kinetic = 0, potential = 0, courant = 0, fastest = 0, deepest = 0;
  double wet = 0, highest = -1e300, lowest = 1e300;
  for (const glm::vec4& c : cells) {
    const double depth = std::max(static_cast<double>(c.x) - c.w, 0.0);
    volume += depth;
    potential += 0.5 * depth * (static_cast<double>(c.x) + c.w);
    deepest = std::max(deepest, depth);
    if (depth > shallow) {
      wet += 1;
      highest = std::max<double>(highest, c.x);
      lowest = std::min<double>(lowest, c.x);
    }
    if (depth <= step.thin) continue;
    const double u = c.y / depth;
    const double v = c.z / depth;
    kinetic += 0.5 * depth * (u * u + v * v);
    fastest = std::max(fastest, std::sqrt(u * u + v * v));
    courant =
        std::max(courant, (std::max(std::abs(u), std::abs(v)) + std::sqrt(p.gravity * depth)) * ratio);
  }
  if (wet == 0) highest = lowest = 0;
  return {volume * area,
          kinetic * area * density,
          potential * area * density * p.gravity,
          courant,
          fastest,
          deepest,
          wet * area,
          highest,
          lowest};
}

}  // namespace simreel::sim
