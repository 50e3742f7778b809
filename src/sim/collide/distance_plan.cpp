#include "sim/collide/distance_plan.hpp"

#include "base/error.hpp"
#include "base/log.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/common.hpp>

namespace simreel::shader::distance {
#include "glsl/collide/distance/bindings.glsl"
}  // namespace simreel::shader::distance

namespace simreel::sim {

namespace {

constexpr int usualCells = 64;
constexpr int maxUsualCells = 256;
constexpr std::int64_t maxUsual = 2'000'000;
constexpr std::int64_t nodeLimit = 4'000'000;  // maximum number of grid nodes; larger grids would exceed
                                               // the maximum number of workgroups (of 64 invocations) in a
                                               // dispatch

/// Returns the number of cells along each axis for a mesh with `along` cells along its longest side,
/// including the cells in the space around it.
glm::ivec3 cellsFor(const glm::dvec3& size, int along, double reach) {
  const double cell = std::max({size.x, size.y, size.z}) / along;
  const auto count = [&](double side) {
    return static_cast<int>(std::min(std::ceil((side + 2 * reach) / cell) + 4, 1e6));
  };
  return {count(size.x), count(size.y), count(size.z)};
}

std::int64_t productOf(const glm::ivec3& cells) {
  return std::int64_t{cells.x} * cells.y * cells.z;
}

}  // namespace

DistancePlan::DistancePlan(const std::string& name, const Mesh& mesh, float scale, int cellsAlong,
                           double reach) {
  const ClosedMesh closed(name, mesh, scale);
  const glm::dvec3 size = closed.high - closed.low;
  const double longest = std::max({size.x, size.y, size.z});
  const double thickness = 2 * closed.volume / closed.area;
  int along = cellsAlong;
  if (along == 0) {
    along = std::clamp(static_cast<int>(std::min(4 * longest / thickness, 1e6)), usualCells, maxUsualCells);
    while (along > 8 && productOf(cellsFor(size, along, reach)) > maxUsual) --along;
  }
  cells = cellsFor(size, along, reach);
  if (productOf(cells + 1) > nodeLimit)
    fail(ExitCode::usage,
         "mesh \"{}\" collides by {}x{}x{} cells, whose corners are more than {}; lower \"distanceCells\" "
         "({}) or the "
         "margins of what touches it ({:.3g} m)",
         name, cells.x, cells.y, cells.z, nodeLimit, along, reach);
  const double side = longest / along;
  if (side > thickness)
    warn(
        "mesh \"{}\" is {:.3g} m thick on the average, and collides by cells of {:.3g} m: thin parts may "
        "be "
        "missed; raise \"distanceCells\" ({})",
        name, thickness, side, along);
  cell = static_cast<float>(side);
  corner = glm::vec3(0.5 * (closed.low + closed.high) - 0.5 * side * glm::dvec3(cells));
  const glm::dvec3 around = side * glm::dvec3(cells);
  unit = static_cast<float>(std::sqrt(around.x * around.x + around.y * around.y + around.z * around.z) /
                            32767);
  plantTree(closed.faces);
}

namespace {

using FaceRange = std::pair<std::size_t, std::size_t>;

/// Orders the faces by a tree of boxes. The faces of each box are split at the median along the longest
/// side of their centroids' bounding box. Returns the range of faces of each box; the boxes are numbered in
/// breadth-first order from 1.
std::vector<FaceRange> splitFaces(const std::vector<ClosedMesh::Face>& from, std::size_t leaves,
                                  std::vector<unsigned>& order) {
  std::vector<glm::vec3> middles;  // sum of each face's corners, which is three times its centroid
  middles.reserve(from.size());
  for (const ClosedMesh::Face& f : from) middles.push_back(f.corners[0] + f.corners[1] + f.corners[2]);
  std::vector<FaceRange> ranges(2 * leaves);
  ranges[1] = {0, from.size()};
  for (std::size_t box = 1; box < leaves; ++box) {
    const auto [begin, end] = ranges[box];
    glm::vec3 low = middles[order[begin]];
    glm::vec3 high = low;
    for (std::size_t i = begin; i < end; ++i) {
      low = glm::min(low, middles[order[i]]);
      high = glm::max(high, middles[order[i]]);
    }
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](unsigned a, unsigned b) {
      return std::tuple(middles[a][axis], a) < std::tuple(middles[b][axis], b);
    });
    ranges[2 * box] = {begin, middle};
    ranges[2 * box + 1] = {middle, end};
  }
  return ranges;
}

}  // namespace

void DistancePlan::plantTree(const std::vector<ClosedMesh::Face>& from) {
  constexpr std::size_t leafFaces = shader::distance::leafFaces;
  std::size_t leaves = 1;
  while (leaves * leafFaces < from.size()) leaves *= 2;
  firstLeaf = static_cast<int>(leaves);
  std::vector<unsigned> order(from.size());
  std::iota(order.begin(), order.end(), 0U);
  const std::vector<FaceRange> ranges = splitFaces(from, leaves, order);
  boxes.assign(4 * leaves, glm::vec4(0));
  const auto add = [&](const glm::vec3& corner) { faces.emplace_back(corner, 0); };
  for (std::size_t leaf = 0; leaf < leaves; ++leaf) {
    const auto [begin, end] = ranges[leaves + leaf];
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin),
              order.begin() + static_cast<std::ptrdiff_t>(end));
    glm::vec3 low(1e30F);
    glm::vec3 high(-1e30F);
    for (std::size_t k = 0; k < leafFaces; ++k) {
      const ClosedMesh::Face& face = from[order[std::min(begin + k, end - 1)]];
      for (const glm::vec3& p : face.corners) {
        low = glm::min(low, p);
        high = glm::max(high, p);
        add(p);
      }
      for (const glm::vec3& n : face.normals) add(n);
    }
    boxes[2 * (leaves + leaf)] = glm::vec4(low, 0);
    boxes[2 * (leaves + leaf) + 1] = glm::vec4(high, leaf * leafFaces);
  }
  for (std::size_t box = leaves - 1; box > 0; --box) {
    boxes[2 * box] = glm::vec4(glm::min(glm::vec3(boxes[4 * box]), glm::vec3(boxes[4 * box + 2])), 0);
    boxes[2 * box + 1] =
        glm::vec4(glm::max(glm::vec3(boxes[4 * box + 1]), glm::vec3(boxes[4 * box + 3])), 0);
  }
  for (std::size_t box = 1; box < 2 * leaves; ++box) {
    std::size_t next = box + 1;
    while (next % 2 == 0) next /= 2;
    boxes[2 * box].w = next == 1 ? 0.0F : static_cast<float>(next);
  }
}

}  // namespace simreel::sim
