#pragma once
// Helpers for tests of colliding meshes.
#include "reference/distance_twin.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::test {

/// Returns a box with these half extents around the origin as OBJ text, with outward faces.
[[nodiscard]] inline std::string boxObj(const glm::dvec3& half, const std::string& more = "") {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += fmt::format("v {} {} {}\n", (i & 1) != 0 ? half.x : -half.x, (i & 2) != 0 ? half.y : -half.y,
                        (i & 4) != 0 ? half.z : -half.z);
  const int quads[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                           {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
  for (const auto& q : quads)
    text += fmt::format("f {} {} {}\nf {} {} {}\n", q[0], q[1], q[2], q[0], q[2], q[3]);
  return text + more;
}

[[nodiscard]] inline scene::Scene parsedScene(const std::string& objects) {
  return scene::parseScene(fmt::format(R"({{"version": 1, "seed": 5, "objects": {{{}}}}})", objects),
                           std::filesystem::temp_directory_path() / "test.json", {}, sim::kinds());
}

[[nodiscard]] inline std::string meshObject(const std::string& more) {
  return R"("solid": {"mesh": {"collides": true, )" + more + "}}";
}

/// Random numbers in [-1, 1) that are the same on every platform.
class Draws {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(static_cast<std::int64_t>(state_) >> 11) / 4503599627370496.0;
  }
  glm::dvec3 inBox(const glm::dvec3& half) {
    return {half.x * (*this)(), half.y * (*this)(), half.z * (*this)()};
  }

 private:
  std::uint64_t state_ = 7;
};

/// Independent implementation in double precision. The distance to a triangle comes from its plane, edges
/// and corners. The winding number around a point is the sum of solid angles (Van Oosterom and Strackee
/// 1983).
class BruteForce {
 public:
  BruteForce(const sim::Mesh& mesh, double scale) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      faces_.push_back({glm::dvec3(mesh.positions[mesh.indices[i]]) * scale,
                        glm::dvec3(mesh.positions[mesh.indices[i + 1]]) * scale,
                        glm::dvec3(mesh.positions[mesh.indices[i + 2]]) * scale});
  }
  [[nodiscard]] double distance(const glm::dvec3& p) const {
    double minimum = 1e30;
    for (const auto& f : faces_) minimum = std::min(minimum, toFace(p, f));
    return minimum;
  }
  [[nodiscard]] double winding(const glm::dvec3& p) const {
    double sum = 0;
    for (const auto& f : faces_) {
      const glm::dvec3 a = f[0] - p;
      const glm::dvec3 b = f[1] - p;
      const glm::dvec3 c = f[2] - p;
      const double la = glm::length(a);
      const double lb = glm::length(b);
      const double lc = glm::length(c);
      sum += std::atan2(glm::dot(a, glm::cross(b, c)),
                        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return sum / (2 * M_PI);
  }

 private:
  using Triangle = std::array<glm::dvec3, 3>;
  static double toSegment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
    const double squared = glm::dot(b - a, b - a);
    const double t = squared > 0 ? std::clamp(glm::dot(p - a, b - a) / squared, 0.0, 1.0) : 0;
    return glm::length(p - a - t * (b - a));
  }
  static double toFace(const glm::dvec3& p, const Triangle& f) {
    double minimum =
        std::min({toSegment(p, f[0], f[1]), toSegment(p, f[1], f[2]), toSegment(p, f[2], f[0])});
    const glm::dvec3 n = glm::cross(f[1] - f[0], f[2] - f[0]);
    if (glm::dot(n, n) == 0) return minimum;
    bool above = true;
    for (std::size_t k = 0; k < 3; ++k)
      above = above && glm::dot(glm::cross(f[(k + 1) % 3] - f[k], p - f[k]), n) >= 0;
    return above ? std::abs(glm::dot(p - f[0], n)) / glm::length(n) : minimum;
  }
  std::vector<Triangle> faces_;
};

}  // namespace simreel::test
