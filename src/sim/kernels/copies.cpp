#include "sim/kernels/copies.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

glm::mat3 axesAlong(const glm::vec3& direction) {
  const float length2 = glm::dot(direction, direction);
  if (!(length2 > 1e-20F) || !std::isfinite(length2)) return glm::mat3(1);
  const glm::vec3 z = direction / std::sqrt(length2);
  const glm::vec3 x =
      glm::normalize(glm::cross(std::abs(z.y) < 0.9999F ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1), z));
  return {x, glm::cross(z, x), z};
}

/// Returns v rotated by a unit quaternion.
glm::vec3 turnedBy(const glm::vec4& q, const glm::vec3& v) {
  const glm::vec3 axis(q);
  return v + 2.0F * glm::cross(axis, glm::cross(axis, v) + q.w * v);
}

bool isDrawn(const glm::vec4& place, const glm::vec4& velocity) {
  const float far = std::abs(place.x) + std::abs(place.y) + std::abs(place.z);
  return velocity.w >= 0 && far < 1e6F;
}

}  // namespace

glm::mat3 copyAxes(Instances::Turning turning, const glm::vec4& turn) {
  if (turning == Instances::Turning::none) return glm::mat3(1);
  if (turning != Instances::Turning::quaternion) return axesAlong(glm::vec3(turn));
  const float length2 = glm::dot(turn, turn);
  if (!(length2 > 1e-20F) || !std::isfinite(length2)) return glm::mat3(1);
  const glm::vec4 q = turn / std::sqrt(length2);
  return {turnedBy(q, {1, 0, 0}), turnedBy(q, {0, 1, 0}), turnedBy(q, {0, 0, 1})};
}

MeshTable copiesOf(const Instances& look, std::span<const glm::vec4> places,
                   std::span<const glm::vec4> velocities, std::span<const glm::vec4> turns) {
  const Mesh mesh = loadMesh(look.mesh, MeshNormals::shared);
  MeshTable all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!isDrawn(places[i], velocities[i])) continue;
    const glm::mat3 axes = copyAxes(look.turning, turns.empty() ? velocities[i] : turns[i]);
    const float masses = std::max(places[i].w, 0.0F) / look.massReference;
    const float scale =
        look.massExponent == 0 ? look.size : look.size * shader::exactPow(masses, look.massExponent);
    const auto first = static_cast<unsigned>(all.positions.size());
    for (const glm::vec3& p : mesh.positions)
      all.positions.push_back(glm::vec3(places[i]) + axes * (scale * p));
    for (const glm::vec3& n : mesh.normals) all.normals.push_back(axes * n);
    all.uvs.insert(all.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    for (const unsigned index : mesh.indices) all.indices.push_back(first + index);
  }
  return all;
}

void append(MeshTable& all, const MeshTable& more) {
  const auto first = static_cast<unsigned>(all.positions.size());
  const bool textured = !all.uvs.empty() || !more.uvs.empty();
  all.positions.insert(all.positions.end(), more.positions.begin(), more.positions.end());
  all.normals.insert(all.normals.end(), more.normals.begin(), more.normals.end());
  if (textured) {
    all.uvs.resize(first);
    all.uvs.insert(all.uvs.end(), more.uvs.begin(), more.uvs.end());
    all.uvs.resize(all.positions.size());
  }
  for (const unsigned index : more.indices) all.indices.push_back(first + index);
  all.doubleSided = all.doubleSided || more.doubleSided;
}

}  // namespace simreel::sim
