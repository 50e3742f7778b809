#include "sim/body/skin_points.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

using Corners = std::array<glm::dvec3, 3>;

/// Returns the skinned position p' = sum w_i M_i p of a vertex p with the joint matrices M_i and weights
/// w_i.
glm::dvec3 skinned(const Figure& figure, const std::vector<glm::vec4>& rows, unsigned vertex) {
  const glm::dvec3 rest(figure.mesh.positions[vertex]);
  glm::dvec3 sum(0);
  for (int k = 0; k < 4; ++k) {
    const double weight = figure.weights[vertex][k];
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec4 row(
          rows[3 * static_cast<std::size_t>(figure.follow[vertex][k]) + static_cast<std::size_t>(axis)]);
      sum[axis] += weight * (row.x * rest.x + row.y * rest.y + row.z * rest.z + row.w);
    }
  }
  return sum;
}

/// Returns the barycentric coordinates of the point of a triangle that is closest to p (Ericson 2005,
/// Real-Time Collision Detection, 5.1.5).
glm::dvec3 nearestOf(const Corners& t, const glm::dvec3& p) {
  const glm::dvec3 ab = t[1] - t[0];
  const glm::dvec3 ac = t[2] - t[0];
  const glm::dvec3 ap = p - t[0];
  const double d1 = glm::dot(ab, ap);
  const double d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const glm::dvec3 bp = p - t[1];
  const double d3 = glm::dot(ab, bp);
  const double d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const glm::dvec3 cp = p - t[2];
  const double d5 = glm::dot(ab, cp);
  const double d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double v = vb / (va + vb + vc);
  const double w = vc / (va + vb + vc);
  return {1 - v - w, v, w};
}

/// Returns the unit axes of a face: along its first edge, perpendicular to this edge in the face's plane,
/// and along the normal.
std::array<glm::dvec3, 3> axesOf(const Corners& t) {
  const auto unit = [](const glm::dvec3& v) { return v / std::sqrt(std::max(glm::dot(v, v), 1e-300)); };
  const glm::dvec3 along = unit(t[1] - t[0]);
  const glm::dvec3 out = unit(glm::cross(t[1] - t[0], t[2] - t[0]));
  return {along, glm::cross(out, along), out};
}

glm::dvec3 placeIn(const Corners& t, const glm::dvec3& shares) {
  return t[0] * shares.x + t[1] * shares.y + t[2] * shares.z;
}

}  // namespace

SkinPoints::SkinPoints(const std::string& body, std::shared_ptr<const BodyMotion> motion,
                       std::span<const glm::dvec3> points, double time)
    : motion_(std::move(motion)) {
  const Figure& figure = motion_->figure();
  const std::vector<glm::vec4> rows = motion_->rowsAt(time);
  std::vector<glm::dvec3> skin;
  for (unsigned i = 0; i < figure.mesh.positions.size(); ++i) skin.push_back(skinned(figure, rows, i));
  for (const glm::dvec3& point : points) {
    Place best{};
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f + 2 < figure.mesh.indices.size(); f += 3) {
      const std::array<unsigned, 3> corners = {figure.mesh.indices[f], figure.mesh.indices[f + 1],
                                               figure.mesh.indices[f + 2]};
      const Corners t = {skin[corners[0]], skin[corners[1]], skin[corners[2]]};
      const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
      if (!(glm::dot(n, n) > 1e-20)) continue;  // skips a degenerate face
      const glm::dvec3 shares = nearestOf(t, point);
      const glm::dvec3 away = point - placeIn(t, shares);
      if (!(glm::dot(away, away) < minimum)) continue;
      minimum = glm::dot(away, away);
      const auto axes = axesOf(t);
      best = {corners, shares, {glm::dot(away, axes[0]), glm::dot(away, axes[1]), glm::dot(away, axes[2])}};
    }
    if (!(minimum < std::numeric_limits<double>::infinity()))
      fail(ExitCode::usage, "body \"{}\" has no faces to which pins could be attached", body);
    places_.push_back(best);
  }
}

std::vector<glm::dvec3> SkinPoints::at(double time) const {
  const Figure& figure = motion_->figure();
  const std::vector<glm::vec4> rows = motion_->rowsAt(time);
  std::vector<glm::dvec3> points;
  points.reserve(places_.size());
  for (const Place& place : places_) {
    Corners t;
    for (std::size_t k = 0; k < 3; ++k) t[k] = skinned(figure, rows, place.corners[k]);
    const auto axes = axesOf(t);
    points.push_back(placeIn(t, place.shares) + axes[0] * place.offset.x + axes[1] * place.offset.y +
                     axes[2] * place.offset.z);
  }
  return points;
}

}  // namespace simreel::sim
