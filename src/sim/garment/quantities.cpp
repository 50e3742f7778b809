#include "sim/garment/quantities.hpp"

#include <bit>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Returns the maximum, or NaN if either argument is NaN.
double greaterOf(double a, double b) {
  return std::isnan(a) || a >= b ? a : b;
}

}  // namespace

std::vector<double> measureGarment(const GarmentPlan& plan, std::span<const glm::vec4> left,
                                   std::span<const glm::vec4> velocities, double time) {
  const std::vector<glm::vec4> positions =
      beforeHalf(left, velocities, plan.parameters().keepsEnergy() ? plan.substepSeconds() : 0.0);
  const glm::dvec3 gravity(plan.parameters().gravity.at(time));
  const shader::FabricConstants fabric = plan.parameters().fabric->constants();
  std::vector<glm::dvec3> points;
  double total = 0;
  double kinetic = 0;
  double potential = 0;
  double fastestSquared = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    points.emplace_back(positions[i]);
    if (i >= plan.masses().size()) continue;  // skips the ghost points of clamped edges
    const double mass = plan.masses()[i];
    const glm::dvec3 v(velocities[i]);
    total += mass;
    kinetic += 0.5 * mass * glm::dot(v, v);
    potential -= mass * glm::dot(gravity, points.back());
    fastestSquared = greaterOf(fastestSquared, glm::dot(v, v));
  }
  double elastic = plateEnergy(plan.plate(), fabric.bending, points);
  double stretch = 0;
  for (std::size_t f = 0; f < plan.membrane().size(); ++f) {
    const auto& corners = plan.cloth().faces[f].corners;
    const FaceStrain strain =
        strainOf(plan.membrane()[f], points[corners[0]], points[corners[1]], points[corners[2]]);
    const glm::dvec3 inverseMasses(positions[corners[0]].w, positions[corners[1]].w,
                                   positions[corners[2]].w);
    elastic += membraneEnergy(plan.membrane()[f],
                              stiffnessOf(plan.membrane()[f], fabric, inverseMasses,
                                          softeningSeconds(plan.parameters(), plan.substepSeconds())),
                              strain);
    stretch = greaterOf(stretch, greaterOf(strain.weft, strain.warp));
  }
  for (const glm::uvec4& a : plan.arrays().attachments) {
    const double beyond =
        glm::distance(points[a.x], points[a.y]) - static_cast<double>(std::bit_cast<float>(a.z));
    double compliance = std::bit_cast<float>(a.w);
    if (plan.parameters().keepsEnergy())
      compliance += plan.substepSeconds() * plan.substepSeconds() * static_cast<double>(positions[a.x].w);
    if (beyond > 0) elastic += 0.5 * beyond * beyond / compliance;
  }
  return {static_cast<double>(plan.masses().size()),
          total,
          kinetic,
          potential,
          elastic,
          kinetic + potential + elastic,
          stretch,
          std::sqrt(fastestSquared)};
}

}  // namespace simreel::sim
