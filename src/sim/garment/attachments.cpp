#include "sim/garment/attachments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::sim {

namespace {

constexpr double unreachedWay = std::numeric_limits<double>::infinity();
/// Minimum fraction of the weight that an attachment must carry; other attachments are omitted.
constexpr double minLacking = 0.2;
/// Fraction of the softness computed by stiffnessOf() that takes effect, because faces support each other.
/// It was measured from the stretch of hanging rows of right-angled and random meshes without attachments.
constexpr double partOfSoftness = 0.75;

double lengthOf(const glm::dvec3& d) {
  return std::sqrt(glm::dot(d, d));
}

/// Path of a front that reaches a third vertex across the segment between two others.
struct WayOver {
  double length = unreachedWay;
  bool second = false;  ///< true if the path crosses the segment nearer to the second vertex
};

/// Computes the path to a third vertex, at the origin, across the segment a-b. If both vertices were
/// reached from one source, the front is a circle around a point behind the segment; otherwise it is a
/// straight line.
WayOver wayOver(const glm::dvec2& a, const glm::dvec2& b, double toA, double toB, bool oneSource) {
  const glm::dvec2 edge = b - a;
  const double e = std::sqrt(glm::dot(edge, edge));
  const double x = -glm::dot(a, edge) / e;
  const double y = std::abs(a.x * b.y - a.y * b.x) / e;
  double crosses = 0;
  double length = 0;
  if (oneSource) {
    const double sx = (toA * toA - toB * toB + e * e) / (2 * e);
    const double sy = std::sqrt(std::max(toA * toA - sx * sx, 0.0));
    crosses = sy + y > 0 ? sx + (x - sx) * sy / (sy + y) : sx;
    length = std::sqrt((x - sx) * (x - sx) + (y + sy) * (y + sy));
  } else {
    const double slope = (toB - toA) / e;
    if (!(std::abs(slope) < 1)) return {};
    const double rise = std::sqrt(1 - slope * slope);
    crosses = x - y * slope / rise;
    length = toA + slope * x + rise * y;
  }
  if (crosses < 0 || crosses > e) return {};
  return {length, crosses > 0.5 * e};
}

/// Propagates fronts from all pins simultaneously, vertex by vertex (fast marching).
class Fronts {
 public:
  Fronts(const ClothTriangles& cloth, const std::vector<bool>& pinned) : cloth_(cloth) {
    const std::size_t count = cloth.points.size();
    ways.lengths.assign(count, unreachedWay);
    ways.pins.assign(count, ClothTriangles::none);
    reached_.assign(count, false);
    for (unsigned i = 0; i < count; ++i)
      if (pinned[i]) reach(i, 0, i);
    while (!open_.empty()) {
      const unsigned next = open_.begin()->second;
      open_.erase(open_.begin());
      reached_[next] = true;
      for (unsigned k = cloth.starts[next]; k < cloth.starts[next + 1]; ++k) {
        const ClothTriangles::Face& face = cloth.faces[cloth.around[k]];
        for (std::size_t side = 0; side < 3; ++side) {
          if (face.corners[side] != next) update(face.corners[side]);
          if (face.corners[side] != next && face.corners[(side + 1) % 3] != next &&
              face.beyond[side] != ClothTriangles::none)
            update(face.beyond[side]);
        }
      }
    }
  }

  PathsToPins ways;

 private:
  void reach(unsigned vertex, double length, unsigned pin) {
    if (!(length < ways.lengths[vertex])) return;
    open_.erase({ways.lengths[vertex], vertex});
    ways.lengths[vertex] = length;
    ways.pins[vertex] = pin;
    open_.emplace(length, vertex);
  }

  void over(unsigned vertex, unsigned a, unsigned b, const glm::dvec2& placeA, const glm::dvec2& placeB) {
    if (!reached_[a] || !reached_[b]) return;
    const WayOver way =
        wayOver(placeA, placeB, ways.lengths[a], ways.lengths[b], ways.pins[a] == ways.pins[b]);
    if (way.length < std::max(ways.lengths[a], ways.lengths[b])) return;
    reach(vertex, way.length, ways.pins[way.second ? b : a]);
  }

  /// Shortens the path of a vertex through the neighbours that were already reached: along edges, across
  /// faces and, because angles at the vertex can be wide, across the next faces, unfolded into one plane.
  void update(unsigned vertex) {
    if (reached_[vertex]) return;
    const glm::dvec3 here = cloth_.points[vertex];
    for (unsigned k = cloth_.starts[vertex]; k < cloth_.starts[vertex + 1]; ++k) {
      const unsigned f = cloth_.around[k];
      const ClothTriangles::Face& face = cloth_.faces[f];
      const std::size_t at = face.corners[0] == vertex ? 0 : face.corners[1] == vertex ? 1 : 2;
      const std::size_t side = (at + 1) % 3;
      const unsigned a = face.corners[side];
      const unsigned b = face.corners[(at + 2) % 3];
      const glm::dvec3 toA = cloth_.points[a] - here;
      const glm::dvec3 toB = cloth_.points[b] - here;
      const double first = lengthOf(toA);
      if (reached_[a]) reach(vertex, ways.lengths[a] + first, ways.pins[a]);
      if (reached_[b]) reach(vertex, ways.lengths[b] + lengthOf(toB), ways.pins[b]);
      const glm::dvec2 placeA(first, 0);
      const glm::dvec2 placeB(glm::dot(toA, toB) / first, 2 * face.area / first);
      over(vertex, a, b, placeA, placeB);
      const unsigned c = face.beyond[side];
      if (c == ClothTriangles::none || !reached_[c]) continue;
      const glm::dvec3 edge = cloth_.points[b] - cloth_.points[a];
      const double squared = glm::dot(edge, edge);
      const double part = glm::dot(cloth_.points[c] - cloth_.points[a], edge) / squared;
      const double height = 2 * cloth_.faces[face.neighbours[side]].area / squared;
      const glm::dvec2 along = placeB - placeA;
      const glm::dvec2 placeC = placeA + along * part + glm::dvec2(along.y, -along.x) * height;
      if (!(placeC.y > 0) || !(placeC.x * placeB.y - placeC.y * placeB.x > 0))
        continue;  // the vertex cannot be seen from the point
      over(vertex, a, c, placeA, placeC);
      over(vertex, c, b, placeC, placeB);
    }
  }

  const ClothTriangles& cloth_;
  std::vector<bool> reached_;
  std::set<std::pair<double, unsigned>> open_;
};

/// Distribution of the weight over the distance from a group of pins that are connected by edges: the mass
/// M beyond the distance s, the width b at s, and the integral U.
class Hanging {
 public:
  Hanging() = default;
  explicit Hanging(double farthest) : width_(std::max(farthest, 1e-9) / bins) {}

  /// Distributes the area (m^2) and mass (kg) of a face evenly over the distances from `from` to `to`.
  void add(double from, double to, double area, double mass) {
    const double first = from / width_;
    const double last = std::max(to / width_, first + 1e-9);
    const auto begin = std::min(static_cast<std::size_t>(first), bins - 1);
    const auto end = std::min(static_cast<std::size_t>(last), bins - 1);
    for (std::size_t k = begin; k <= end; ++k) {
      const double lower = std::max(first, static_cast<double>(k));
      const double upper = k == bins - 1 ? last : std::min(last, static_cast<double>(k + 1));
      const double part = std::max(upper - lower, 0.0) / (last - first);
      areas_[k] += part * area;
      masses_[k] += part * mass;
    }
  }

  /// Returns the integral U at a distance, in kg.
  [[nodiscard]] double lowered(double distance) const {
    double beyond = 0;
    for (const double mass : masses_) beyond += mass;
    double sum = 0;
    for (std::size_t k = 0; k < bins; ++k) {
      const double part = std::clamp(distance / width_ - static_cast<double>(k), 0.0, 1.0);
      if (part <= 0 || areas_[k] <= 0) break;
      sum += (beyond - 0.5 * masses_[k] * part) * part * width_ * width_ / areas_[k];
      beyond -= masses_[k];
    }
    return sum;
  }

 private:
  static constexpr std::size_t bins = 64;
  double width_ = 1;
  std::array<double, bins> areas_{}, masses_{};
};

/// Returns the stiffness (N/m) along a strip that is cut at an angle to the weft. `cosine` and `sine` are
/// the squares of the angle's cosine and sine.
double alongWay(const FaceStiffness& k, double cosine, double sine) {
  return 1 / (cosine * cosine / k.weft + sine * sine / k.warp + cosine * sine / k.shear);
}

/// Returns the cluster of the pin of each vertex. Pins that are connected by edges form a cluster, which is
/// named by the lowest index of its pins.
std::vector<unsigned> clustersOf(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                 const PathsToPins& ways) {
  std::vector<unsigned> first(pinned.size());
  for (unsigned i = 0; i < first.size(); ++i) first[i] = i;
  const auto root = [&](unsigned i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  for (const ClothTriangles::Face& face : cloth.faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned a = face.corners[k];
      const unsigned b = face.corners[(k + 1) % 3];
      if (!pinned[a] || !pinned[b]) continue;
      const unsigned low = std::min(root(a), root(b));
      first[std::max(root(a), root(b))] = low;
    }
  std::vector<unsigned> clusters;
  for (const unsigned pin : ways.pins) clusters.push_back(pin == ClothTriangles::none ? pin : root(pin));
  return clusters;
}

}  // namespace

PathsToPins waysToPins(const ClothTriangles& cloth, const std::vector<bool>& pinned) {
  PathsToPins ways = Fronts(cloth, pinned).ways;
  for (std::size_t i = 0; i < ways.pins.size(); ++i)
    if (ways.pins[i] != ClothTriangles::none)  // If the cluster has several pins, the pin from which the
                                               // front started is unknown.
      ways.lengths[i] = std::max(ways.lengths[i], lengthOf(cloth.points[ways.pins[i]] - cloth.points[i]));
  return ways;
}

std::vector<Attachment> attachmentsOf(const ClothTriangles& cloth, const std::vector<bool>& pinned,
                                      const std::vector<MembraneElement>& membrane,
                                      const std::vector<double>& masses,
                                      const shader::FabricConstants& fabric, double seconds) {
  const PathsToPins ways = waysToPins(cloth, pinned);
  const std::vector<unsigned> clusters = clustersOf(cloth, pinned, ways);
  std::map<unsigned, double> farthest;
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (clusters[i] != ClothTriangles::none) {
      double& maximum = farthest[clusters[i]];
      maximum = std::max(maximum, ways.lengths[i]);
    }
  std::map<unsigned, Hanging> hanging;
  for (const auto& [cluster, maximum] : farthest) hanging.emplace(cluster, Hanging(maximum));
  for (const ClothTriangles::Face& face : cloth.faces)
    for (const unsigned corner : face.corners) {  // each corner gets a third of the face's area and mass
      if (clusters[corner] == ClothTriangles::none) continue;
      double from = unreachedWay;
      double to = 0;
      for (const unsigned other : face.corners) {
        from = std::min(from, ways.lengths[other]);
        to = std::max(to, ways.lengths[other]);
      }
      hanging[clusters[corner]].add(from, to, face.area / 3,
                                    static_cast<double>(fabric.density) * face.area / 3);
    }
  std::vector<Attachment> attachments;
  for (unsigned i = 0; i < clusters.size(); ++i) {
    if (clusters[i] == ClothTriangles::none || pinned[i]) continue;
    const glm::dvec3 way = cloth.points[ways.pins[i]] - cloth.points[i];
    double whole = 0;
    double left = 0;
    for (unsigned k = cloth.starts[i]; k < cloth.starts[i + 1]; ++k) {
      const auto& corners = cloth.faces[cloth.around[k]].corners;
      const MembraneElement& e = membrane[cloth.around[k]];
      const glm::dvec3 b = cloth.points[corners[1]] - cloth.points[corners[0]];
      const glm::dvec3 c = cloth.points[corners[2]] - cloth.points[corners[0]];
      const double u = glm::dot(way, b * e.p + c * e.q);
      const double v = glm::dot(way, b * e.r + c * e.s);
      const double both = u * u + v * v;
      const double cosine = both > 0 ? u * u / both : 1;
      glm::dvec3 inverse(0);
      for (int n = 0; n < 3; ++n) {
        const unsigned corner = corners[static_cast<std::size_t>(n)];
        inverse[n] = pinned[corner] ? 0 : 1 / masses[corner];
      }
      whole += 1 / alongWay({fabric.weft, fabric.warp, fabric.shear}, cosine, 1 - cosine);
      left += 1 / alongWay(stiffnessOf(e, fabric, inverse, seconds * std::sqrt(partOfSoftness)), cosine,
                           1 - cosine);
    }
    const double around = cloth.starts[i + 1] - cloth.starts[i];
    const double lacking = 1 - whole / left;
    if (lacking < minLacking) continue;
    const double compliance =
        hanging[clusters[i]].lowered(ways.lengths[i]) * (whole / around) / (masses[i] * lacking);
    attachments.push_back({i, ways.pins[i], ways.lengths[i], compliance});
  }
  return attachments;
}

}  // namespace simreel::sim
