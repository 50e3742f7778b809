#include "sim/garment/triangles.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Minimum area of a face as a fraction of the squared length of its longest edge; smaller faces are
/// degenerate.
constexpr double minArea = 1e-5;
/// Maximum number of faces around a vertex. They all have different colours, and colours are processed one
/// after another.
constexpr unsigned maxFacesAroundVertex = 256;

using Spot = std::array<float, 3>;

Spot placeOf(const glm::vec3& p) {
  return {p.x, p.y, p.z};
}

/// Returns for each vertex the index of the first vertex at the same position.
std::vector<unsigned> firstAtPlace(const Mesh& mesh) {
  std::vector<unsigned> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](unsigned a, unsigned b) {
    const Spot p = placeOf(mesh.positions[a]);
    const Spot q = placeOf(mesh.positions[b]);
    return p != q ? p < q : a < b;
  });
  std::vector<unsigned> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.positions[order[i]] == mesh.positions[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// Returns for each vertex the first vertex that can be reached from it by steps of at most `reach`
/// (metres) between vertices.
std::vector<unsigned> firstWithin(const Mesh& mesh, double scale, double reach) {
  std::vector<unsigned> first(mesh.positions.size());
  std::iota(first.begin(), first.end(), 0U);
  const auto root = [&](unsigned i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  using Cell = std::array<long, 3>;
  std::map<Cell, std::vector<unsigned>> cells;
  for (unsigned i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3 p = glm::dvec3(mesh.positions[i]) * scale;
    Cell at{};
    for (int k = 0; k < 3; ++k)
      at[static_cast<std::size_t>(k)] =
          static_cast<long>(std::floor(std::clamp(p[k] / reach, -1e15, 1e15)));
    for (int near = 0; near < 27; ++near) {
      const Cell cell{at[0] + near % 3 - 1, at[1] + near / 3 % 3 - 1, at[2] + near / 9 - 1};
      const auto found = cells.find(cell);
      if (found == cells.end()) continue;
      for (const unsigned other : found->second) {
        const glm::dvec3 d = glm::dvec3(mesh.positions[other]) * scale - p;
        if (glm::dot(d, d) > reach * reach) continue;
        const unsigned a = root(i);
        const unsigned b = root(other);
        first[std::max(a, b)] = std::min(a, b);
      }
    }
    cells[at].push_back(i);
  }
  for (unsigned i = 0; i < first.size(); ++i) first[i] = root(i);
  return first;
}

std::string placeText(const glm::dvec3& p) {
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g})", p.x, p.y, p.z);
}

}  // namespace

ClothTriangles::ClothTriangles(const std::string& name, const Mesh& mesh, double scale, double weld) {
  const std::vector<unsigned> first = weld > 0 ? firstWithin(mesh, scale, weld) : firstAtPlace(mesh);
  vertexOf.resize(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      vertexOf[i] = static_cast<unsigned>(points.size());
      points.push_back(glm::dvec3(mesh.positions[i]) * scale);
    } else {
      vertexOf[i] = vertexOf[first[i]];
    }
  }
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    Face face{};
    for (std::size_t k = 0; k < 3; ++k) face.corners[k] = vertexOf[mesh.indices[i + k]];
    face.neighbours.fill(none);
    face.beyond.fill(none);
    const glm::dvec3 a = points[face.corners[0]];
    const glm::dvec3 b = points[face.corners[1]] - a;
    const glm::dvec3 c = points[face.corners[2]] - a;
    const glm::dvec3 n = glm::cross(b, c);
    face.area = 0.5 * std::sqrt(glm::dot(n, n));
    const double longest = std::max({glm::dot(b, b), glm::dot(c, c), glm::dot(b - c, b - c)});
    if (!(face.area > minArea * longest))
      fail(ExitCode::usage,
           "{}: face {} (vertices {}, {} and {}) has no area, {}; remove it, or \"weld\" closer", name,
           i / 3, mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2], placeText(a));
    faces.push_back(face);
  }
  join(name);
  gather(name);
}

void ClothTriangles::join(const std::string& name) {
  struct Edge {
    unsigned low, high, face, side;
  };
  std::vector<Edge> edges;
  edges.reserve(faces.size() * 3);
  for (unsigned f = 0; f < faces.size(); ++f)
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned a = faces[f].corners[k];
      const unsigned b = faces[f].corners[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), f, k});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.low, a.high, a.face, a.side} < std::array{b.low, b.high, b.face, b.side};
  });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    const Edge& first = edges[i];
    if (end - i > 2)
      fail(ExitCode::usage,
           "{}: an edge belongs to {} faces ({}, {}, {}...), {}; at most two faces may share an edge, so "
           "separate them",
           name, end - i, first.face, edges[i + 1].face, edges[i + 2].face, placeText(points[first.low]));
    if (end - i == 2) {
      const Edge& second = edges[i + 1];
      Face& here = faces[first.face];
      Face& there = faces[second.face];
      if (here.corners[first.side] == there.corners[second.side])
        fail(ExitCode::usage, "{}: faces {} and {} face opposite ways, {}; turn one over", name, first.face,
             second.face, placeText(points[first.low]));
      here.neighbours[first.side] = second.face;
      there.neighbours[second.side] = first.face;
      here.beyond[first.side] = there.corners[(second.side + 2) % 3];
      there.beyond[second.side] = here.corners[(first.side + 2) % 3];
    }
    i = end;
  }
}

void ClothTriangles::gather(const std::string& name) {
  starts.assign(points.size() + 1, 0);
  for (const Face& face : faces)
    for (const unsigned corner : face.corners) ++starts[corner + 1];
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (starts[i + 1] == 0) {
      const auto copy =
          std::find(vertexOf.begin(), vertexOf.end(), static_cast<unsigned>(i)) - vertexOf.begin();
      fail(ExitCode::usage, "{}: vertex {} belongs to no face, {}; remove it", name, copy,
           placeText(points[i]));
    }
    if (starts[i + 1] > maxFacesAroundVertex)
      fail(ExitCode::usage, "{}: {} faces meet in one vertex, {}, more than {}; make it finer there", name,
           starts[i + 1], placeText(points[i]), maxFacesAroundVertex);
    starts[i + 1] += starts[i];
  }
  around.resize(starts.back());
  std::vector<unsigned> filled(starts.begin(), starts.end() - 1);
  for (unsigned f = 0; f < faces.size(); ++f)
    for (const unsigned corner : faces[f].corners) around[filled[corner]++] = f;
}

int ClothTriangles::sew(const std::vector<std::pair<unsigned, unsigned>>& stitches) {
  sewn_.resize(points.size());
  std::iota(sewn_.begin(), sewn_.end(), 0U);
  const auto root = [&](unsigned i) {
    while (sewn_[i] != i) i = sewn_[i];
    return i;
  };
  for (const auto& [a, b] : stitches) {
    const unsigned first = root(a);
    const unsigned second = root(b);
    sewn_[std::max(first, second)] = std::min(first, second);
  }
  for (unsigned i = 0; i < sewn_.size(); ++i) sewn_[i] = root(i);
  int opposite = 0;
  std::map<std::pair<unsigned, unsigned>, std::pair<unsigned, std::size_t>>
      borders;  // border edges; the key
                // holds the vertices at the
                // ends
  for (unsigned f = 0; f < faces.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      if (faces[f].neighbours[k] != none) continue;
      const unsigned from = sewn_[faces[f].corners[k]];
      const unsigned to = sewn_[faces[f].corners[(k + 1) % 3]];
      if (borders.count({from, to}) != 0) ++opposite;
      const auto found = borders.find({to, from});
      if (from == to || found == borders.end() || found->second.first == f) {
        borders.try_emplace({from, to}, f, k);
        continue;
      }
      const auto [other, side] = found->second;
      borders.erase(found);
      faces[f].neighbours[k] = other;
      faces[f].beyond[k] = faces[other].corners[(side + 2) % 3];
      faces[other].neighbours[side] = f;
      faces[other].beyond[side] = faces[f].corners[(k + 2) % 3];
    }
  return opposite;
}

std::size_t ClothTriangles::sideBeyond(unsigned face, std::size_t side) const {
  const Face& here = faces[face];
  const Face& there = faces[here.neighbours[side]];
  std::size_t k = 0;
  while (k < 2 && (there.neighbours[k] != face ||
                   firstOf(there.corners[k]) != firstOf(here.corners[(side + 1) % 3])))
    ++k;
  return k;
}

std::vector<int> colourFaces(const ClothTriangles& cloth) {
  std::vector<int> colours(cloth.faces.size(), -1);
  std::vector<unsigned> taken;  // for each colour, index of the last face that found the colour in use at
                                // one of its vertices
  for (unsigned f = 0; f < cloth.faces.size(); ++f) {
    for (const unsigned corner : cloth.faces[f].corners)
      for (unsigned k = cloth.starts[corner]; k < cloth.starts[corner + 1]; ++k) {
        const int colour = colours[cloth.around[k]];
        if (colour < 0) continue;
        if (taken.size() <= static_cast<std::size_t>(colour))
          taken.resize(static_cast<std::size_t>(colour) + 1, ClothTriangles::none);
        taken[static_cast<std::size_t>(colour)] = f;
      }
    const auto free = std::find_if(taken.begin(), taken.end(), [&](unsigned by) { return by != f; });
    colours[f] = static_cast<int>(free - taken.begin());
  }
  return colours;
}

ClothEdges edgesOf(const ClothTriangles& cloth) {
  std::vector<std::set<unsigned>> others(cloth.points.size());
  for (const ClothTriangles::Face& face : cloth.faces)
    for (const unsigned corner : face.corners)
      for (const unsigned other : face.corners)
        if (other != corner) others[corner].insert(other);
  ClothEdges all;
  std::vector<glm::uvec4> vertices;
  for (std::size_t i = 0; i < others.size(); ++i) {
    vertices.emplace_back(i, all.edges.size(), others[i].size(), 0);
    for (const unsigned other : others[i])
      all.edges.emplace_back(
          other,
          std::bit_cast<unsigned>(static_cast<float>(glm::distance(cloth.points[i], cloth.points[other]))),
          0, 0);
  }
  for (const unsigned vertex : cloth.vertexOf) all.vertices.push_back(vertices[vertex]);
  return all;
}

}  // namespace simreel::sim
