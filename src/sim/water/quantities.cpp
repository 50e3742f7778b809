#include "sim/water/quantities.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

constexpr double density = 1000;  ///< Density of water in kg/m^3.

}  // namespace

std::span<const scene::Quantity> WaterParameters::quantities() const {
  static constexpr scene::Quantity list[] = {
      {"volume", "m^3", "Volume of all water, without the part that floats displace."},
      {"kineticEnergy", "J", "Kinetic energy of all water, at 1000 kg/m^3."},
      {"potentialEnergy", "J", "Potential energy of all water over level 0."},
      {"courant", "", "Greatest (|u| + sqrt(g h)) dt / cell along an axis."},
      {"fastest", "m/s", "Greatest speed of water that is deeper than 1/10,000 of the greatest depth."},
      {"deepest", "m", "Greatest depth."},
      {"wetArea", "m^2", "Area of cells with more than 1/200 of the greatest depth."},
      {"highestLevel", "m", "Highest level of the cells that \"wetArea\" counts."},
      {"lowestLevel", "m",
       "Lowest level of the cells that \"wetArea\" counts; both levels are 0 if there are none."},
      {"displaced", "m^3",
       "Volume that all floats displace below the reference level of each, which follows the water around "
       "it."},
      {"floatSpeed", "m/s", "Speed of the fastest float."},
      {"leastUpright", "", "Least cosine of the angle between a float's y and upwards."},
      {"draft", "m",
       "Depth of the first float's lowest point below the mean level of the water there; 0 without "
       "floats."},
      {"floatX", "m", "x of the first float's centre of mass, from the middle of the grid."},
      {"floatY", "m", "Height of the first float's centre of mass over level 0."},
      {"floatZ", "m", "z of the first float's centre of mass, from the middle of the grid."}};
  return list;
}

namespace {

/// Returns the y component of the vector v rotated by the quaternion q.
double heightOf(const glm::dvec4& q, const glm::dvec3& v) {
  return 2 * (q.x * q.y + q.z * q.w) * v.x + (1 - 2 * (q.x * q.x + q.z * q.z)) * v.y +
         2 * (q.y * q.z - q.x * q.w) * v.z;
}

}  // namespace

std::vector<double> measureFloats(const WaterPlan& plan, std::span<const glm::vec4> floats) {
  double displaced = 0, fastest = 0, upright = 1, draft = 0;
  glm::dvec3 at(0);
  constexpr std::size_t each = shader::floatTexels;
  for (std::size_t i = 0; i < floats.size() / each; ++i) {
    const glm::dvec4 q(floats[each * i + 1]);
    const glm::dvec4 v(floats[each * i + 2]);
    displaced += v.w;
    fastest = std::max(fastest, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
    upright = std::min(upright, heightOf(q, {0, 1, 0}));
    if (i > 0) continue;
    at = glm::dvec3(floats[0]);
    double lowest = 1e300;
    for (const glm::vec3& p : plan.floats().hulls()[0].corners)
      lowest = std::min(lowest, heightOf(q, glm::dvec3(p)));
    draft = floats[4].z - (at.y + lowest);
  }
  return {displaced, fastest, upright, draft, at.x, at.y, at.z};
}

glm::vec4 waterSumFactors(const WaterParameters& parameters) {
  const double area = static_cast<double>(parameters.cell) * parameters.cell;
  const double weight = area * density;
  return {area, weight, weight * parameters.gravity, area};
}

std::vector<double> measureWater(const WaterPlan& plan, std::span<const glm::vec4> cells,
                                 std::span<const glm::vec4> floats) {
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
  const std::vector<double> ofFloats = measureFloats(plan, floats);
  std::vector<double> measured = {volume * area - ofFloats[0],
                                  kinetic * area * density,
                                  potential * area * density * p.gravity,
                                  courant,
                                  fastest,
                                  deepest,
                                  wet * area,
                                  highest,
                                  lowest};
  measured.insert(measured.end(), ofFloats.begin(), ofFloats.end());
  return measured;
}

}  // namespace simreel::sim
