#pragma once
#include "sim/garment/plan.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

/// Helpers that make meshes and parameters for tests of cloth from triangles.
namespace simreel::test {

enum class Kind { right, equilateral, random };

/// Returns a pseudo-random number from -1 to 1 that depends on `i`.
[[nodiscard]] inline double disorder(std::size_t i) {
  const double x = 43758.5453 * std::sin(12.9898 * static_cast<double>(i + 1));
  return 2 * (x - std::floor(x)) - 1;
}

/// Returns a rectangle around the origin in the xz plane, facing +y, that consists of cells of size `cell`
/// (m). Columns at both ends are straight. The first `kept` columns and all borders are not disturbed.
[[nodiscard]] inline sim::Mesh rectangle(Kind kind, glm::ivec2 cells, double cell, int kept = 1) {
  sim::Mesh mesh;
  const double deep = kind == Kind::equilateral ? std::sqrt(0.75) * cell : cell;
  for (int z = 0; z <= cells.y; ++z)
    for (int x = 0; x <= cells.x; ++x) {
      const bool inside = x >= kept && x < cells.x;
      double across = x - 0.5 * cells.x;
      double down = z - 0.5 * cells.y;
      if (kind == Kind::equilateral && inside && z % 2 == 1) across += 0.5 - (x == 0 ? 0.5 : 0.0);
      if (kind == Kind::equilateral && x == cells.x && z % 2 == 1) across += 0;
      if (kind == Kind::random && inside && z > 0 && z < cells.y) {
        const auto number = static_cast<std::size_t>(z * (cells.x + 1) + x);
        across += 0.3 * disorder(2 * number);
        down += 0.3 * disorder(2 * number + 1);
      }
      mesh.positions.emplace_back(across * cell, 0.0, down * deep);
      mesh.normals.emplace_back(0, 1, 0);
      mesh.uvs.emplace_back(across / cells.x + 0.5, down / cells.y + 0.5);
    }
  for (int z = 0; z < cells.y; ++z)
    for (int x = 0; x < cells.x; ++x) {
      const auto a = static_cast<unsigned>(z * (cells.x + 1) + x);
      const unsigned below = a + static_cast<unsigned>(cells.x) + 1;
      const bool other = kind == Kind::equilateral ? z % 2 == 1
                         : kind == Kind::random    ? (31 * x + 17 * z) % 3 == 0
                                                   : false;
      if (other)
        mesh.indices.insert(mesh.indices.end(), {a, below, below + 1, a, below + 1, a + 1});
      else
        mesh.indices.insert(mesh.indices.end(), {a, below, a + 1, a + 1, below, below + 1});
    }
  return mesh;
}

/// Returns the mesh as OBJ text.
[[nodiscard]] inline std::string objOf(const sim::Mesh& mesh) {
  std::string text;
  for (const glm::vec3& p : mesh.positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
  for (const glm::vec2& uv : mesh.uvs) text += fmt::format("vt {} {}\n", uv.x, uv.y);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return fmt::format("{0}/{0}", mesh.indices[i + k] + 1); };
    text += fmt::format("f {} {} {}\n", corner(0), corner(1), corner(2));
  }
  return text;
}

/// Returns parameters of a cloth mesh without gravity, wind, damping or pins.
[[nodiscard]] inline sim::ClothParameters freeCloth() {
  sim::ClothParameters p;
  p.mesh.emplace();
  p.fabric.emplace();
  p.gravity = glm::vec3(0);
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.substeps.reset();
  p.pins.clear();
  return p;
}

/// Adds a pin for all vertices in the box.
inline void pinBox(sim::ClothParameters& parameters, const glm::vec3& min, const glm::vec3& max) {
  sim::PinGroup& group = parameters.pins.emplace_back();
  group.box = sim::PinBox{min, max};
}

}  // namespace simreel::test
