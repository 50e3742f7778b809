// Tests generated meshes: counts, index ranges, outward orientation, areas.
#include "base/hash.hpp"
#include "scene/load.hpp"
#include "sim/core/kind.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/world/list.hpp"

#include <filesystem>
#include <numbers>
#include <span>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Checks that the mesh is valid. Returns its area in m^2.
double checkedArea(const sim::Mesh& mesh) {
  CHECK(mesh.normals.size() == mesh.positions.size());
  CHECK((mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size()));
  CHECK(mesh.indices.size() % 3 == 0);
  int bad = 0;
  for (const glm::vec3& n : mesh.normals) bad += std::abs(glm::length(n) - 1.0F) < 1e-5F ? 0 : 1;
  double area = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const unsigned a = mesh.indices[i];
    const glm::vec3 p = mesh.positions.at(a);
    const glm::vec3 face =
        glm::cross(mesh.positions.at(mesh.indices[i + 1]) - p, mesh.positions.at(mesh.indices[i + 2]) - p);
    const float twice = glm::length(face);
    area += 0.5 * twice;
    if (twice < 1e-6F) continue;  // Degenerate triangles at a pole are skipped.
    glm::vec3 middle(0);
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.normals[mesh.indices[i + k]];
    bad += glm::dot(face / twice, glm::normalize(middle)) > 0.9F ? 0 : 1;
  }
  CHECK(bad == 0);
  return area;
}

}  // namespace

TEST_CASE("a plane of 401x401 vertices has 32-bit indices and faces up") {
  const sim::Mesh plane = sim::planeMesh({8, 0, 4}, {401, 401});
  CHECK(plane.positions.size() == 160'801);
  CHECK(plane.indices.size() == 3 * 320'000);
  CHECK(checkedArea(plane) == doctest::Approx(32));
  CHECK(plane.positions.back() == glm::vec3(4, 0, 2));
  CHECK(plane.uvs.back() == glm::vec2(1, 1));
  CHECK(plane.indices.back() == 160'800);
}

TEST_CASE("spheres, capsules and tori face outwards and have the right area") {
  const double pi = std::numbers::pi;
  CHECK(checkedArea(sim::sphereMesh(1.5F, {97, 66})) == doctest::Approx(4 * pi * 2.25).epsilon(0.005));
  CHECK(checkedArea(sim::capsuleMesh(0.5F, 2)) == doctest::Approx(pi + 2 * pi).epsilon(0.005));
  CHECK(checkedArea(sim::torusMesh(2, 0.5F, {97, 49})) == doctest::Approx(4 * pi * pi).epsilon(0.005));
  CHECK(checkedArea(sim::geodesicMesh(1.5F, 13)) == doctest::Approx(4 * pi * 2.25).epsilon(0.01));
  CHECK(sim::sphereMesh(1, {4, 3}).positions.size() == 12);
}

TEST_CASE("round meshes have the same bits on every machine") {
  const auto bitsOf = [](const sim::Mesh& mesh) {
    return hashHex(std::as_bytes(std::span(mesh.positions))) +
           hashHex(std::as_bytes(std::span(mesh.normals)));
  };
  CHECK(bitsOf(sim::sphereMesh(1.3F, {37, 23})) ==
        "925997b55ea434bac0709cfb7a2aeaebfc17de4987d8b202a6204d902f904ba0");
  CHECK(bitsOf(sim::capsuleMesh(0.4F, 1.7F)) ==
        "478ae616effaab302cb1f800b0532844984f37a55bac0e2ad34640a887ead859");
  CHECK(bitsOf(sim::torusMesh(1.1F, 0.3F, {41, 19})) ==
        "2f1c970898a196908d8731a43d3d52efa43a8c0e0c65099dd1657bfb437365d3");
}

TEST_CASE("mesh: two numbers are enough for the size of a plane and the scale of a texture") {
  const auto parsed = [](const std::string& object) {
    return scene::parseScene(R"({"version": 2, "objects": {"m": {)" + object + "}}}",
                             std::filesystem::temp_directory_path() / "test.json", {}, sim::kinds());
  };
  const auto sizeOf = [&](const std::string& shape, const std::string& size) {
    const scene::Scene scene = parsed(R"("mesh": {"shape": ")" + shape + R"(", "size": )" + size + "}");
    return sim::parametersOf<sim::MeshParameters>(scene.objects.at(0)).size;
  };
  CHECK(sizeOf("plane", "[4, 3]") == glm::vec3(4, 0, 3));
  CHECK(sizeOf("plane", "[4, 0, 3]") == glm::vec3(4, 0, 3));
  CHECK(sizeOf("grass", "[4, 3]") == glm::vec3(4, 0, 3));
  CHECK_THROWS_WITH(sizeOf("box", "[4, 3]"),
                    doctest::Contains("expected a list of three numbers, found 2"));
  CHECK_THROWS_WITH(sizeOf("plane", "[4]"),
                    doctest::Contains("expected a list of two or three numbers, found 1"));
  const scene::Scene scene = parsed(R"("box": {}, "material": {"textureScale": [5, 2]})");
  CHECK(scene.objects.at(0).material.textureScale == glm::vec3(5, 2, 1));
}
