#include "sim/mesh/deform_rest.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr unsigned maxFacesAround =
    20'000;  // limited because some drivers silently end a shader loop after 65,535 iterations

bool before(const glm::vec3& a, const glm::vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// Returns for each vertex the index of the first vertex with the same position and (nearly) the same
/// normal.
std::vector<unsigned> firstCopies(const Mesh& mesh) {
  std::vector<unsigned> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](unsigned a, unsigned b) {
    if (before(mesh.positions[a], mesh.positions[b])) return true;
    if (before(mesh.positions[b], mesh.positions[a])) return false;
    return a < b;
  });
  std::vector<unsigned> first(order.size());
  std::vector<unsigned> kept;  // first copies at the current position, each with a different normal
  for (std::size_t i = 0; i < order.size(); ++i) {
    const unsigned vertex = order[i];
    if (i == 0 || mesh.positions[vertex] != mesh.positions[order[i - 1]]) kept.clear();
    const auto same = std::find_if(kept.begin(), kept.end(), [&](unsigned other) {
      return glm::dot(mesh.normals[vertex], mesh.normals[other]) > 0.999F;
    });
    first[vertex] = same == kept.end() ? vertex : *same;
    if (same == kept.end() && kept.size() < 64) kept.push_back(vertex);
  }
  return first;
}

}  // namespace

RestMesh::RestMesh(const std::string& name, const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  const std::vector<unsigned> first = firstCopies(mesh);
  std::vector<unsigned> around(count);
  std::vector<float> shortest(count, 1e30F);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const unsigned vertex = first[mesh.indices[i]];
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const float edge = glm::length(mesh.positions[mesh.indices[i]] - mesh.positions[mesh.indices[next]]);
    if (edge > 0)
      for (const unsigned end : {vertex, first[mesh.indices[next]]})
        shortest[end] = std::min(shortest[end], edge);
    if (++around[vertex] > maxFacesAround)
      fail(ExitCode::usage,
           "mesh \"{}\": more than {} triangles meet in vertex {}; a mesh to deform has to be finer", name,
           maxFacesAround, vertex);
  }
  fans.assign(count, glm::uvec4(0));
  unsigned elements = 0;
  for (std::size_t v = 0; v < count; ++v) {
    fans[v] = {elements, (around[v] + 1) / 2, 0, 0};
    elements += fans[v].y;
  }
  faces.reserve(elements);
  for (std::size_t v = 0; v < count; ++v)
    faces.insert(faces.end(), fans[v].y, glm::uvec4(static_cast<unsigned>(v)));
  std::vector<unsigned> filled(count);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t face = i - i % 3;
    const unsigned vertex = first[mesh.indices[i]];
    const unsigned place = filled[vertex]++;
    glm::uvec4& pair = faces[fans[vertex].x + place / 2];
    pair[static_cast<int>(place % 2 * 2)] = mesh.indices[face + (i + 1) % 3];
    pair[static_cast<int>(place % 2 * 2 + 1)] = mesh.indices[face + (i + 2) % 3];
  }
  positions.reserve(count);
  normals.reserve(count);
  for (std::size_t v = 0; v < count; ++v) {
    fans[v] = fans[first[v]];
    const float edge = shortest[first[v]];
    positions.emplace_back(mesh.positions[v], edge < 1e30F ? edge : 1e-3F);
    normals.emplace_back(mesh.normals[v], 0.0F);
  }
}

}  // namespace simreel::sim
