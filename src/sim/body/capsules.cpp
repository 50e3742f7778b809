#include "sim/body/capsules.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace simreel::sim {

namespace {

constexpr double minShare = 1.0 / 300;  ///< minimum dominated area for a capsule, as a fraction of the
                                        ///< skin's area

/// Returns the minimum area that a bone must dominate to get a capsule.
double minArea(std::vector<double> areas) {
  double total = 0;
  for (const double area : areas) total += area;
  std::sort(areas.begin(), areas.end(), std::greater<>());
  const double last = areas.size() > maxCapsules ? areas[maxCapsules - 1] : 0;
  return std::max(last, minShare * total);
}

/// Vertex that a bone dominates, in bone space.
struct Spot {
  glm::dvec3 place;
  double area;  ///< area in m^2: a third of the area of the triangles around the vertex
};

struct Weighed {
  double value;
  double area;
};

double areaOf(const std::vector<Spot>& spots) {
  double sum = 0;
  for (const Spot& spot : spots) sum += spot.area;
  return sum;
}

/// Returns the area-weighted mean of the values between the quantiles `low` and `high`.
double meanBetween(std::vector<Weighed> values, double low, double high) {
  std::stable_sort(values.begin(), values.end(),
                   [](const Weighed& a, const Weighed& b) { return a.value < b.value; });
  double total = 0;
  for (const Weighed& v : values) total += v.area;
  double before = 0;
  double sum = 0;
  double counted = 0;
  for (const Weighed& v : values) {
    const double from = std::max(before, low * total);
    const double to = std::min(before + v.area, high * total);
    before += v.area;
    if (to <= from) continue;
    sum += v.value * (to - from);
    counted += to - from;
  }
  return counted > 0 ? sum / counted : 0;
}

double toSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 axis = b - a;
  const double squared = glm::dot(axis, axis);
  const double t = squared > 0 ? std::clamp(glm::dot(p - a, axis) / squared, 0.0, 1.0) : 0;
  const glm::dvec3 offset = p - (a + axis * t);
  return std::sqrt(glm::dot(offset, offset));
}

/// Returns the area of each vertex: a third of the area of the triangles around it.
std::vector<double> vertexAreas(const Mesh& mesh) {
  std::vector<double> areas(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                         glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a);
    const double third = std::sqrt(glm::dot(normal, normal)) / 6;
    for (std::size_t k = 0; k < 3; ++k) areas[mesh.indices[i + k]] += third;
  }
  return areas;
}

/// Returns the end of a bone's axis: the mean position of its children.
glm::dvec3 childOf(const Figure& figure, std::size_t joint, const glm::dmat4& toBone) {
  glm::dvec3 sum(0);
  double count = 0;
  for (const FigureJoint& other : figure.joints) {
    if (!other.bone ||
        figure.nodes[static_cast<std::size_t>(other.node)].parent != figure.joints[joint].node)
      continue;
    sum += glm::dvec3(toBone * glm::inverse(other.inverseBind)[3]);
    ++count;
  }
  return count > 0 ? sum / count : sum;
}

BoneCapsule fitted(int node, const std::vector<Spot>& spots, const glm::dvec3& child) {
  const double area = areaOf(spots);
  glm::dvec3 middle(0);
  double reach = 0;
  for (const Spot& spot : spots) {
    middle += spot.place * (spot.area / area);
    reach = std::max(reach, glm::length(spot.place));
  }
  // The axis points to the child. If the child is too close to the bone, the axis points to the centre of
  // the skin.
  const bool leads = glm::length(child) > 0.25 * reach;
  const glm::dvec3 along = leads ? child : middle;
  const double length = glm::length(along);
  const glm::dvec3 way = length > 1e-9 ? along / length : glm::dvec3(0, 1, 0);
  double low = 0;
  double high = leads ? length : 0;
  if (!leads)
    for (const Spot& spot : spots) high = std::max(high, glm::dot(spot.place, way));
  const glm::dvec3 aside = middle - way * glm::dot(middle, way);
  const auto place = [&](double at) { return aside + way * at; };
  std::vector<Weighed> distances;
  const auto measure = [&] {
    distances.clear();
    for (const Spot& spot : spots)
      distances.push_back({toSegment(spot.place, place(low), place(high)), spot.area});
    return meanBetween(distances, 0.25, 0.75);
  };
  double radius = measure();
  if (!leads) {
    // The skin has a round end, so the axis ends one radius before the skin does. The radius depends on the
    // axis, so both are found by iteration.
    double reached = high;
    for (int round = 0; round < 8; ++round) {
      high = std::max(reached - radius, low);
      radius = measure();
    }
  }
  return {node, {place(low), place(high)}, radius};
}

}  // namespace

std::vector<BoneCapsule> fitCapsules(const Figure& figure) {
  const std::vector<double> areas = vertexAreas(figure.mesh);
  std::vector<std::vector<Spot>> spots(figure.joints.size());
  for (std::size_t i = 0; i < figure.mesh.positions.size(); ++i) {
    int maximum = 0;
    for (int k = 1; k < 4; ++k)
      if (figure.weights[i][k] > figure.weights[i][maximum]) maximum = k;
    const std::size_t joint = figure.follow[i][maximum];
    const glm::dvec4 place(glm::dvec3(figure.mesh.positions[i]), 1);
    spots[joint].push_back({glm::dvec3(figure.joints[joint].inverseBind * place), areas[i]});
  }
  std::vector<double> boneAreas;
  for (std::size_t joint = 0; joint < spots.size(); ++joint)
    boneAreas.push_back(figure.joints[joint].bone ? areaOf(spots[joint]) : 0);
  const double minimum = minArea(boneAreas);
  std::vector<BoneCapsule> capsules;
  for (std::size_t joint = 0; joint < spots.size(); ++joint) {
    if (!(boneAreas[joint] >= minimum) || !(minimum > 0) || capsules.size() == maxCapsules) continue;
    const FigureJoint& bone = figure.joints[joint];
    capsules.push_back(fitted(bone.node, spots[joint], childOf(figure, joint, bone.inverseBind)));
  }
  return capsules;
}

}  // namespace simreel::sim
