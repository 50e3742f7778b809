#include "draw/exact/motion/velocities.hpp"

#include "draw/draw_state.hpp"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::draw {

void Velocities::addSurface(const sim::Surface& surface, std::size_t i, unsigned firstId, int triangles) {
  Motion::Displacement way = motion_.displacementOf(i);
  if (way.now.empty()) return;
  meshes_.push_back({firstId, firstId + static_cast<unsigned>(triangles), rowOf(surface),
                     surface.indices->readAll<unsigned>(), std::move(way)});
}

void Velocities::addInstances(std::size_t i, unsigned firstId, unsigned each) {
  clouds_.push_back({firstId, each, motion_.velocitiesOf(i)});
}

glm::vec3 Velocities::at(unsigned number, const glm::dvec3& place) const {
  for (const Mesh& mesh : meshes_)
    if (number >= mesh.firstId && number < mesh.end) return onMesh(mesh, number - mesh.firstId, place);
  for (const Cloud& cloud : clouds_) {
    if (number < cloud.firstId) continue;
    const std::size_t instance = (number - cloud.firstId) / cloud.each;
    if (instance < cloud.velocities.size()) return glm::vec3(cloud.velocities[instance]);
  }
  return glm::vec3(0);
}

glm::vec3 Velocities::onMesh(const Mesh& mesh, unsigned triangle, const glm::dvec3& place) const {
  unsigned offset = 0;
  if (mesh.row.x > 0) {
    const auto inRow = static_cast<unsigned>(mesh.row.x);
    offset = triangle / inRow * static_cast<unsigned>(mesh.row.y);
    triangle %= inRow;
  }
  std::array<glm::dvec3, 3> before, now, shown;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t index = std::size_t{3} * triangle + k;
    if (index >= mesh.indices.size()) return glm::vec3(0);
    const std::size_t vertex = std::size_t{mesh.indices[index]} + offset;
    if (vertex >= mesh.way.now.size()) return glm::vec3(0);
    before[k] = glm::dvec3(mesh.way.before[vertex]);
    now[k] = glm::dvec3(mesh.way.now[vertex]);
    shown[k] = before[k] + part_ * (now[k] - before[k]);
  }
  const glm::dvec3 shares = barycentricWeights(shown[0], shown[1], shown[2], place);
  glm::dvec3 way(0);
  for (int k = 0; k < 3; ++k) {
    const auto corner = static_cast<std::size_t>(k);
    way += shares[k] * (now[corner] - before[corner]);
  }
  return glm::vec3(way / seconds_);
}

// Solves place - a = v (b - a) + w (c - a) for v and w by least squares.
glm::dvec3 barycentricWeights(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                              const glm::dvec3& place) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = place - a;
  const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
  const double pb = glm::dot(ap, ab), pc = glm::dot(ap, ac);
  const double area = bb * cc - bc * bc;
  if (!(area > 0)) return {1, 0, 0};
  const double v = (cc * pb - bc * pc) / area, w = (bb * pc - bc * pb) / area;
  const glm::dvec3 shares = glm::max(glm::dvec3(1 - v - w, v, w), glm::dvec3(0));
  return shares / (shares.x + shares.y + shares.z);
}

}  // namespace simreel::draw
