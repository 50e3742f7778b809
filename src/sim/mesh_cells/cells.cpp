#include "sim/mesh_cells/cells.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Returns the cell of each vertex, or -1 for vertices without a face. Cells are numbered in the order in
/// which faces first use their positions. Positions that differ by at most a millionth of the mesh's extent
/// are merged, to tolerate rounding errors of computed vertices.
std::vector<int> weldedNumbers(const Mesh& mesh, std::vector<glm::dvec3>& places) {
  glm::vec3 low(mesh.positions.empty() ? glm::vec3(0) : mesh.positions.front()), high = low;
  for (const glm::vec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double grain = std::max(1e-6 * glm::distance(glm::dvec3(low), glm::dvec3(high)), 1e-30);
  std::vector<std::array<std::int64_t, 3>> keys;
  for (const glm::vec3& p : mesh.positions) {
    const glm::dvec3 at = glm::dvec3(p) / grain;
    keys.push_back({std::llround(at.x), std::llround(at.y), std::llround(at.z)});
  }
  const auto before = [&](unsigned a, unsigned b) { return keys[a] < keys[b]; };
  std::vector<unsigned> sorted(mesh.positions.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i] = static_cast<unsigned>(i);
  std::stable_sort(sorted.begin(), sorted.end(), before);
  std::vector<unsigned> firstAt(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
    firstAt[sorted[i]] = i > 0 && !before(sorted[i - 1], sorted[i]) ? firstAt[sorted[i - 1]] : sorted[i];
  std::vector<int> numbers(mesh.positions.size(), -1);
  for (const unsigned vertex : mesh.indices) {
    int& number = numbers[firstAt[vertex]];
    if (number < 0) {
      number = static_cast<int>(places.size());
      places.emplace_back(mesh.positions[vertex]);
    }
    numbers[vertex] = number;
  }
  return numbers;
}

using CellTriangle = std::array<int, 3>;

/// Returns the faces as triples of cell indices, without degenerate faces.
std::vector<CellTriangle> cellTriangles(const Mesh& mesh, const std::vector<int>& cellOf) {
  std::vector<CellTriangle> triangles;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const CellTriangle t = {cellOf[mesh.indices[i]], cellOf[mesh.indices[i + 1]],
                            cellOf[mesh.indices[i + 2]]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace

MeshCells cellsOf(const Mesh& mesh, const std::string& whose) {
  MeshCells cells;
  cells.cellOf = weldedNumbers(mesh, cells.places);
  cells.areas.assign(cells.places.size(), 0.0);
  std::map<std::pair<int, int>, double> weights;  // weight of each edge
  double area = 0;
  for (const CellTriangle& t : cellTriangles(mesh, cells.cellOf)) {
    const glm::dvec3 p[] = {cells.places[static_cast<std::size_t>(t[0])],
                            cells.places[static_cast<std::size_t>(t[1])],
                            cells.places[static_cast<std::size_t>(t[2])]};
    const double twice = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    area += twice / 2;
    for (int i = 0; i < 3; ++i) {
      const int a = t[static_cast<std::size_t>((i + 1) % 3)], b = t[static_cast<std::size_t>((i + 2) % 3)];
      double& weight = weights[{std::min(a, b), std::max(a, b)}];
      cells.areas[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])] += twice / 6;
      // Limits the cotangents of slivers, so that a single face does not force a small time step.
      const double cotangent =
          glm::dot(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]) / std::max(twice, 1e-30);
      weight += 0.5 * std::clamp(cotangent, -20.0, 20.0);
    }
  }
  if (!(area > 0))
    fail(ExitCode::inputOutput, "{}: the mesh has no face with an area, so there are no cells", whose);
  double edges = 0;
  std::vector<int> degrees(cells.places.size() + 1, 0);
  for (const auto& [edge, weight] : weights) {
    ++degrees[static_cast<std::size_t>(edge.first)];
    ++degrees[static_cast<std::size_t>(edge.second)];
    edges += glm::distance(cells.places[static_cast<std::size_t>(edge.first)],
                           cells.places[static_cast<std::size_t>(edge.second)]);
  }
  cells.meanEdge = edges / static_cast<double>(weights.size());
  cells.first.assign(cells.places.size() + 1, 0);
  for (std::size_t i = 0; i < cells.places.size(); ++i) cells.first[i + 1] = cells.first[i] + degrees[i];
  cells.links.resize(2 * weights.size());
  std::vector<int> next(cells.first.begin(), cells.first.end() - 1);
  const auto add = [&](int from, int to, double weight) {
    cells.links[static_cast<std::size_t>(next[static_cast<std::size_t>(from)]++)] = {to, weight};
  };
  // Edges are sorted by their lower cell, then by their higher cell. If the lower neighbours are added
  // first, the links of each cell are sorted.
  for (const auto& [edge, weight] : weights) add(edge.second, edge.first, weight);
  for (const auto& [edge, weight] : weights) add(edge.first, edge.second, weight);
  cells.low = cells.high = cells.places.front();
  for (const glm::dvec3& place : cells.places) {
    cells.low = glm::min(cells.low, place);
    cells.high = glm::max(cells.high, place);
  }
  return cells;
}

namespace {

struct RefinedEdge {
  int middle = 0;          ///< index of the new vertex in the middle of the edge
  glm::dvec3 opposite{0};  ///< sum of the positions of the opposite corners
  int faces = 0;
};

using RefinedEdges = std::map<std::pair<int, int>, RefinedEdge>;

/// Returns the new positions of the vertices. A vertex has the weight 1 - n b and each of its n neighbours
/// the weight b; at borders, the weights are 3/4 and 1/8 for each of the two neighbours on the border.
std::vector<glm::dvec3> movedVertices(const std::vector<glm::dvec3>& places, const RefinedEdges& edges) {
  std::vector<glm::dvec3> around(places.size(), glm::dvec3(0)), border(places.size(), glm::dvec3(0));
  std::vector<int> neighbours(places.size(), 0), borders(places.size(), 0);
  for (const auto& [ends, edge] : edges)
    for (const auto& [from, to] :
         {std::pair(ends.first, ends.second), std::pair(ends.second, ends.first)}) {
      const auto i = static_cast<std::size_t>(from);
      around[i] += places[static_cast<std::size_t>(to)];
      ++neighbours[i];
      if (edge.faces == 2) continue;
      border[i] += places[static_cast<std::size_t>(to)];
      ++borders[i];
    }
  std::vector<glm::dvec3> moved;
  moved.reserve(places.size() + edges.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const int n = neighbours[i];
    const double c = 0.375 + 0.25 * ieee::cos(2 * std::numbers::pi / std::max(n, 1));
    const double b = (0.625 - c * c) / std::max(n, 1);
    if (borders[i] == 0)
      moved.push_back(places[i] * (1 - n * b) + around[i] * b);
    else
      moved.push_back(borders[i] == 2 ? 0.75 * places[i] + 0.125 * border[i] : places[i]);
  }
  return moved;
}

/// Returns the normal of each vertex: the sum of the normals of its faces, weighted by the faces' areas.
std::vector<glm::vec3> normalsAt(const std::vector<glm::dvec3>& places,
                                 const std::vector<unsigned>& indices) {
  std::vector<glm::dvec3> sums(places.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const unsigned* t = &indices[i];
    const glm::dvec3 normal = glm::cross(places[t[1]] - places[t[0]], places[t[2]] - places[t[0]]);
    for (int k = 0; k < 3; ++k) sums[t[k]] += normal;
  }
  std::vector<glm::vec3> normals;
  normals.reserve(sums.size());
  for (const glm::dvec3& sum : sums) {
    const double length = glm::length(sum);
    normals.emplace_back(length > 0 ? sum / length : glm::dvec3(0, 1, 0));
  }
  return normals;
}

}  // namespace

Mesh refined(const Mesh& mesh) {
  std::vector<glm::dvec3> places;
  const std::vector<CellTriangle> triangles = cellTriangles(mesh, weldedNumbers(mesh, places));
  RefinedEdges edges;
  const auto at = [&](int i) { return places[static_cast<std::size_t>(i)]; };
  for (const CellTriangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      RefinedEdge& edge = edges[std::minmax(t[(i + 1) % 3], t[(i + 2) % 3])];
      edge.opposite += at(t[i]);
      ++edge.faces;
    }
  std::vector<glm::dvec3> moved = movedVertices(places, edges);
  for (auto& [ends, edge] : edges) {
    edge.middle = static_cast<int>(moved.size());
    const glm::dvec3 both = at(ends.first) + at(ends.second);
    moved.push_back(edge.faces == 2 ? 0.375 * both + 0.125 * edge.opposite : 0.5 * both);
  }
  Mesh fine;
  for (const CellTriangle& t : triangles) {
    const auto middle = [&](std::size_t i, std::size_t j) {
      return edges.at(std::minmax(t[i], t[j])).middle;
    };
    const int a = middle(0, 1), b = middle(1, 2), c = middle(2, 0);
    for (const int corner : {t[0], a, c, t[1], b, a, t[2], c, b, a, b, c})
      fine.indices.push_back(static_cast<unsigned>(corner));
  }
  for (const glm::dvec3& place : moved) fine.positions.emplace_back(place);
  fine.normals = normalsAt(moved, fine.indices);
  return fine;
}

}  // namespace simreel::sim
