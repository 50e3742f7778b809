#include "sim/water/hull.hpp"

#include "base/error.hpp"
#include "sim/collide/closed_mesh.hpp"
#include "sim/mesh/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

namespace simreel::sim {

namespace {

constexpr int raysAcross = 4;       ///< Number of rays per cuboid along x and along z.
constexpr int longestCuboids = 48;  ///< Maximum number of cuboids along the longest side.
constexpr double fewestPoints =
    600;  ///< Minimum number of cuboids in the bounding box, unless longestCuboids limits it.

/// Returns, in ascending order, the heights at which a vertical line enters and leaves the body.
using Crossings = std::function<std::vector<double>(std::size_t column)>;

Mesh boxMesh(const glm::vec3& size) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = -1; side <= 1; side += 2) {
      glm::vec3 normal(0);
      glm::vec3 u(0);
      glm::vec3 v(0);
      normal[axis] = static_cast<float>(side);
      u[(axis + 1) % 3] = 0.5F * size[(axis + 1) % 3];
      v[(axis + 2) % 3] = 0.5F * size[(axis + 2) % 3];
      const glm::vec3 middle = normal * (0.5F * size[axis]);
      const auto first = static_cast<unsigned>(mesh.positions.size());
      for (int corner = 0; corner < 4; ++corner) {
        const float a = corner == 1 || corner == 2 ? 1.0F : -1.0F;
        const float b = corner >= 2 ? 1.0F : -1.0F;
        mesh.positions.push_back(middle + u * a + v * b);
        mesh.normals.push_back(normal);
        mesh.uvs.emplace_back(0.5F + 0.5F * a, 0.5F - 0.5F * b);
      }
      const unsigned turn = side > 0 ? 0 : 2;  // Swaps corners 1 and 3, which reverses the winding.
      for (const unsigned i : {0U, 1U + turn, 2U, 0U, 2U, 3U - turn}) mesh.indices.push_back(first + i);
    }
  return mesh;
}

Mesh meshOf(const WaterFloat& body) {
  switch (body.shape) {
    case WaterFloatShape::ball:
      return sphereMesh(body.radius, {49, 25});
    case WaterFloatShape::box:
      return boxMesh(body.size);
    case WaterFloatShape::file:
      break;
  }
  Mesh mesh = loadMesh(body.file);
  for (glm::vec3& p : mesh.positions) p *= body.scale;
  return mesh;
}

ClosedMesh closedOf(const Mesh& mesh, const std::string& name) {
  try {
    return {name, mesh, 1};
  } catch (const UserError& error) {
    fail(error.code(),
         "{}; what floats may also be a \"box\" or \"ball\" for which an open mesh is \"drawn\"",
         error.what());
  }
}

/// Vertical lines through the body, raysAcross^2 per column of cuboids.
struct Rays {
  glm::dvec3 low, step;
  int across, down;

  [[nodiscard]] double x(int i) const {
    return low.x + (i + 0.50003) * step.x;
  }  // Rays are offset from the centres by a small odd fraction, so that they do not hit mesh edges
     // exactly.
  [[nodiscard]] double z(int j) const { return low.z + (j + 0.49996) * step.z; }
};

/// Returns the sorted heights at which each line crosses the mesh's faces.
std::vector<std::vector<double>> crossed(const Rays& rays, const ClosedMesh& mesh) {
  std::vector<std::vector<double>> heights(static_cast<std::size_t>(rays.across) *
                                           static_cast<std::size_t>(rays.down));
  const auto firstOf = [](double from, double low, double step) {
    return static_cast<int>(std::max(0.0, std::floor((from - low) / step) - 1));
  };
  for (const ClosedMesh::Face& face : mesh.faces) {
    const glm::dvec3 a(face.corners[0]);
    const glm::dvec3 b(face.corners[1]);
    const glm::dvec3 c(face.corners[2]);
    const double twice = (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
    if (twice == 0) continue;
    const glm::dvec3 low = glm::min(a, glm::min(b, c));
    const glm::dvec3 high = glm::max(a, glm::max(b, c));
    for (int j = firstOf(low.z, rays.low.z, rays.step.z); j < rays.down && rays.z(j) <= high.z; ++j)
      for (int i = firstOf(low.x, rays.low.x, rays.step.x); i < rays.across && rays.x(i) <= high.x; ++i) {
        const double x = rays.x(i);
        const double z = rays.z(j);
        const double u = ((x - a.x) * (c.z - a.z) - (z - a.z) * (c.x - a.x)) / twice;
        const double v = ((b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x)) / twice;
        if (u < 0 || v < 0 || u + v > 1) continue;
        heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(rays.across) +
                static_cast<std::size_t>(i)]
            .push_back(a.y + u * (b.y - a.y) + v * (c.y - a.y));
      }
  }
  for (std::vector<double>& line : heights) std::sort(line.begin(), line.end());
  return heights;
}

std::vector<std::vector<double>> crossedBall(const Rays& rays, double radius) {
  std::vector<std::vector<double>> heights;
  for (int j = 0; j < rays.down; ++j)
    for (int i = 0; i < rays.across; ++i) {
      const double left = radius * radius - rays.x(i) * rays.x(i) - rays.z(j) * rays.z(j);
      const double half = std::sqrt(std::max(left, 0.0));
      heights.push_back(left > 0 ? std::vector<double>{-half, half} : std::vector<double>{});
    }
  return heights;
}

/// Returns the number of cuboids along each side of a box: the smallest numbers whose product is at least
/// fewestPoints.
glm::ivec3 cuboidsOf(const glm::dvec3& extent) {
  const double longest = std::max({extent.x, extent.y, extent.z});
  glm::ivec3 counts(1);
  for (int n = 8; n <= longestCuboids; ++n) {
    for (int i = 0; i < 3; ++i)
      counts[i] = std::max(2, static_cast<int>(std::floor(n * extent[i] / longest + 0.5)));
    if (static_cast<double>(counts.x) * counts.y * counts.z >= fewestPoints) break;
  }
  return counts;
}

/// Part of a body inside one cuboid.
struct Part {
  double volume = 0;
  glm::dvec3 moment{0};  ///< product of volume and centre
};

/// Integrates the body over each cuboid along vertical rays. Each entry of `lines` holds the heights at
/// which a ray enters and leaves the body.
std::vector<Part> partsOf(const Rays& rays, const std::vector<std::vector<double>>& lines,
                          const glm::ivec3& counts, const glm::dvec3& grain) {
  std::vector<Part> parts(static_cast<std::size_t>(counts.x) * static_cast<std::size_t>(counts.y) *
                          static_cast<std::size_t>(counts.z));
  for (int j = 0; j < rays.down; ++j)
    for (int i = 0; i < rays.across; ++i) {
      const auto& line = lines[static_cast<std::size_t>(j) * static_cast<std::size_t>(rays.across) +
                               static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k + 1 < line.size(); k += 2)
        for (int y = 0; y < counts.y; ++y) {
          const double bottom = std::max(line[k], rays.low.y + y * grain.y);
          const double top = std::min(line[k + 1], rays.low.y + (y + 1) * grain.y);
          if (top <= bottom) continue;
          const std::size_t at =
              (static_cast<std::size_t>(j / raysAcross) * static_cast<std::size_t>(counts.y) +
               static_cast<std::size_t>(y)) *
                  static_cast<std::size_t>(counts.x) +
              static_cast<std::size_t>(i / raysAcross);
          const double part = (top - bottom) * rays.step.x * rays.step.z;
          parts[at].volume += part;
          parts[at].moment += part * glm::dvec3(rays.x(i), 0.5 * (bottom + top), rays.z(j));
        }
    }
  return parts;
}

}  // namespace

Hull::Hull(const WaterFloat& body, const std::string& name) : mesh(meshOf(body)) {
  const ClosedMesh closed = closedOf(mesh, name);
  const bool ball = body.shape == WaterFloatShape::ball;
  const double radius = body.radius;
  volume = ball ? 4.0 / 3 * std::numbers::pi * radius * radius * radius : closed.volume;
  area = ball ? 4 * std::numbers::pi * radius * radius : closed.area;
  mass = body.mass.value_or(body.density * volume);
  const glm::dvec3 low = ball ? glm::dvec3(-radius) : closed.low;
  const glm::dvec3 extent = ball ? glm::dvec3(2 * radius) : closed.high - closed.low;
  height = extent.y;
  const glm::ivec3 counts = cuboidsOf(extent);
  grain = extent / glm::dvec3(counts);
  const Rays rays{
      low, {grain.x / raysAcross, 0, grain.z / raysAcross}, counts.x * raysAcross, counts.z * raysAcross};
  const auto lines = ball ? crossedBall(rays, radius) : crossed(rays, closed);
  for (const auto& line : lines)
    if (line.size() > 1) outline += rays.step.x * rays.step.z;
  const std::vector<Part> parts = partsOf(rays, lines, counts, grain);
  double found = 0;
  for (const Part& part : parts) {
    found += part.volume;
    middle += part.moment;
  }
  middle /= found;
  middle += glm::dvec3(body.ballast);
  const double perVolume = volume / found;
  for (const Part& part : parts) {
    if (part.volume <= 0) continue;
    const glm::dvec3 at = part.moment / part.volume - middle;
    const double own = part.volume * perVolume;
    points.emplace_back(glm::vec3(at), static_cast<float>(own));
    aside2 += own / volume * (at.x * at.x + at.z * at.z);
    // Computes the inertia about the centre of mass as if the ballast were distributed like the volume.
    const double kg = mass * own / volume;
    const glm::dvec3 r = at + glm::dvec3(body.ballast);
    const glm::dvec3 squared = r * r + grain * grain / 12.0;
    inertia[0] += kg * (squared.y + squared.z);
    inertia[1] += kg * (squared.x + squared.z);
    inertia[2] += kg * (squared.x + squared.y);
    inertia[3] -= kg * r.x * r.y;
    inertia[4] -= kg * r.x * r.z;
    inertia[5] -= kg * r.y * r.z;
  }
  for (const glm::vec3& p : mesh.positions) {
    const glm::dvec3 d = glm::dvec3(p) - middle;
    corners.emplace_back(d);
    reach = std::max(reach, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
  }
  if (!body.drawn.empty()) {
    mesh = loadMesh(body.drawn);
    for (glm::vec3& p : mesh.positions) p *= body.scale;
  }
  for (glm::vec3& p : mesh.positions) p = glm::vec3(glm::dvec3(p) - middle);
  touched = ball || body.apart ? FloatShape(body.apart.value_or(radius)) : FloatShape(closed, middle);
}

std::array<double, 6> Hull::inverseInertia() const {
  const auto [xx, yy, zz, xy, xz, yz] = inertia;
  const double a = yy * zz - yz * yz;
  const double b = xz * yz - xy * zz;
  const double c = xy * yz - xz * yy;
  const double all = xx * a + xy * b + xz * c;
  return {a / all, (xx * zz - xz * xz) / all, (xx * yy - xy * xy) / all, b / all,
          c / all, (xy * xz - xx * yz) / all};
}

}  // namespace simreel::sim
