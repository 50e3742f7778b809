#include "sim/mesh/quantities.hpp"

#include "sim/mesh/parameters.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace simreel::sim {

std::span<const scene::Quantity> MeshParameters::quantities() const {
  static const scene::Quantity table[] = {
      {"population", "", "Number of vertices."},
      {"lowest", "m", "Height of the lowest vertex."},
      {"highest", "m", "Height of the highest vertex."},
      {"meanHeight", "m", "Mean height of all vertices."},
      {"area", "m^2", "Area of all triangles."},
      {"volume", "m^3",
       "Enclosed volume; for an open mesh, the volume of the cones from the origin to its triangles."}};
  return table;
}

std::vector<double> measureMesh(const MeshTable& mesh) {
  double lowest = mesh.positions.at(0).y;
  double highest = lowest;
  double sum = 0;
  for (const glm::vec3& p : mesh.positions) {
    lowest = std::min(lowest, double{p.y});
    highest = std::max(highest, double{p.y});
    sum += p.y;
  }
  double area = 0;
  double volume = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 b(mesh.positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(mesh.positions[mesh.indices[i + 2]]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    area += 0.5 * std::sqrt(glm::dot(n, n));
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  const auto count = static_cast<double>(mesh.positions.size());
  return {count, lowest, highest, sum / count, area, volume};
}

}  // namespace simreel::sim
