// Tests OBJ as specified in the Advanced Visualizer's manual and as other programs write it. Each line must
// either have its specified meaning or be refused.
#include "base/error.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"

#include <chrono>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

namespace simreel::test::polygons_obj {

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

sim::Mesh meshOf(const std::string& text) {
  const TemporaryFile file("polygons.obj", text);
  return sim::importMesh(file.path());
}

std::string refusalOf(const std::string& text) {
  try {
    static_cast<void>(meshOf(text));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::inputOutput);
    return error.what();
  }
  return "nothing was refused";
}

/// Returns the positions of each triangle's corners as digits.
std::string drawn(const sim::Mesh& mesh) {
  std::string all;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec3& p = mesh.positions[mesh.indices[i]];
    all += fmt::format("{}{:g},{:g},{:g}", i == 0 ? "" : i % 3 == 0 ? " | " : " ", p.x, p.y, p.z);
  }
  return all;
}

const std::string square = "0,0,0 1,0,0 1,1,0 | 0,0,0 1,1,0 0,1,0";

}  // namespace

TEST_CASE("OBJ: numbers in every notation are read, and no vertex is skipped") {
  CHECK(drawn(meshOf("v .5 0 0\nv +1. -.5e0 1E-1\nv 1 1 0\nv 0 1 0\nf 1 2 3\n")) ==
        "0.5,0,0 1,-0.5,0.1 1,1,0");
  CHECK(drawn(meshOf("\xEF\xBB\xBF" + corners + "v 5 5 5\nf 1 2 3 4\n")) == square);
  CHECK(drawn(meshOf("v 1e-60 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n")) == "0,0,0 1,0,0 1,1,0");
  checkHas(refusalOf("v 0 0 0\nv nan 0 0\nv 1 1 0\nf 1 2 3\n"), "line 2 \"nan\", which is not finite");
  checkHas(refusalOf("v 0 0 0\nv 1,5 0 0\n"), "line 2 \"1,5\", where a number is expected");
  checkHas(refusalOf("v 0 0 0\nv 1 2\n"), "line 2 a vertex of 2 numbers");
  checkHas(refusalOf("v 0 0 0 1 2\n"), "line 1 a vertex of 5 numbers");
  checkHas(refusalOf("v 0 0 0\nvt x\n"), "line 2 \"x\"");
}

TEST_CASE("OBJ: vertex weights are ignored, and colours after positions or weights are read") {
  CHECK(drawn(meshOf("v 0 0 0 1\nv 1 0 0 0.5\nv 1 1 0 2\nv 0 1 0 1\nf 1 2 3 4\n")) == square);
  const sim::Mesh six = meshOf("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nf 1 2 3\n");
  REQUIRE(six.colors.size() == 3);
  CHECK(six.colors[0] == glm::vec3(1, 0, 0));
  const sim::Mesh seven = meshOf("v 0 0 0 2 1 0 0\nv 1 0 0\nv 1 1 0 1 0 0 1\nf 1 2 3\n");
  REQUIRE(seven.colors.size() == 3);
  CHECK(seven.colors[0] == glm::vec3(1, 0, 0));
  CHECK(seven.colors[1] == glm::vec3(1));
  CHECK(seven.colors[2] == glm::vec3(0, 0, 1));
}

TEST_CASE("OBJ: comments, backslash continuations and all three line endings are read") {
  CHECK(drawn(meshOf("v 0 0 0 # 7 7 7\nv 1 0 0#8\nv 1 1 0\nv 0 1 0\nf 1 2 3 # 4\n")) ==
        "0,0,0 1,0,0 1,1,0");
  CHECK(drawn(meshOf("# goes on \\\n" + corners + "f 1 2 \\\n  3 4\n")) == square);
  CHECK(drawn(meshOf("v 0 \\\r\n 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4")) == square);
  CHECK(drawn(meshOf("v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r")) == square);
}

TEST_CASE("OBJ: absolute, relative and forward indices of corners are read") {
  CHECK(drawn(meshOf(corners + "f -4 -3 -2 -1\n")) == square);
  CHECK(drawn(meshOf(corners + "f -4 -3 -2 -1\nv 9 9 9\n")) == square);
  CHECK(drawn(meshOf("f 1 2 3 4\n" + corners)) == square);
  CHECK(drawn(meshOf(corners + "vt 0 0\nvn 0 0 1\nf 1/1 2//1 3/1/1 4\n")) == square);
  checkHas(refusalOf(corners + "f 1 2 5\n"), "line 5 a face with vertex 5, and there are 4");
  checkHas(refusalOf(corners + "f -5 2 3\n"), "line 5 \"-5\", and there are 4 before");
  checkHas(refusalOf(corners + "f 0 1 2\n"), "line 5 \"0\", which is no number of a vertex");
  const sim::Mesh lacking = meshOf(corners + "vt 0 0\nf 1/1 2/2 3/2\nf 1//2 3//2 4//2\n");
  CHECK(drawn(lacking) == square);
  CHECK(lacking.undrawn == std::vector<std::string>{"normals that are named and missing (3)",
                                                    "texture coordinates that are named and missing (2)"});
  checkHas(refusalOf(corners + "f 1/1/1/1 2 3\n"), "which is no corner of a face");
  checkHas(refusalOf(corners + "f 1 two 3\n"), "line 5 \"two\"");
}

TEST_CASE("OBJ: elements that are not drawn are reported by kind and count") {
  CHECK(meshOf(corners + "f 1 2 3\n").undrawn.empty());
  CHECK(meshOf("mtllib\no x\ng a b\ns 1\nusemtl\n" + corners + "bevel on\nf 1 2 3\n").undrawn.empty());
  const sim::Mesh mesh =
      meshOf(corners + "p 1\nl 1 2\nl 2 3\nvp 0.5\ncstype bezier\ndeg 3\nf 1 2\nf 1 2 3 4\ncall x.obj\n");
  CHECK(drawn(mesh) == square);
  CHECK(mesh.undrawn == std::vector<std::string>{"curves and surfaces of free form",
                                                 "faces of fewer than three corners (1)", "lines (2)",
                                                 "lines that begin with \"call\" (1)", "points (1)"});
  checkHas(refusalOf(corners + "l 1 2\n"), "holds no triangle, but lines (1)");
}

TEST_CASE("OBJ: smoothing groups give smooth normals, and faces outside groups are flat") {
  // The roof consists of two squares that share an edge along y at a right angle.
  const std::string roof = "v 1 0 0\nv 1 1 0\nv 0 1 1\nv 0 0 1\nv -1 1 0\nv -1 0 0\n";
  const auto normals = [&](const std::string& first, const std::string& second) {
    const sim::Mesh mesh = meshOf(roof + first + "f 1 2 3 4\n" + second + "f 4 3 5 6\n");
    std::vector<glm::vec3> atRidge;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
      if (mesh.positions[i].z == 1.0F) atRidge.push_back(mesh.normals[i]);
    return atRidge;
  };
  const float slope = std::sqrt(0.5F);
  for (const auto& [first, second] :
       {std::pair("", ""), {"s off\n", ""}, {"s 0\n", ""}, {"s 1\n", "s 2\n"}, {"s 1\n", "s off\n"}}) {
    CAPTURE(first);
    const std::vector<glm::vec3> flat = normals(first, second);
    REQUIRE(flat.size() == 4);
    for (const glm::vec3& n : flat) CHECK(std::abs(std::abs(n.x) - slope) < 1e-6F);
  }
  for (const char* group : {"s 1\n", "s on\n", "s 4000000000\n"}) {
    const std::vector<glm::vec3> smooth = normals(group, "");
    REQUIRE(smooth.size() == 2);
    for (const glm::vec3& n : smooth)
      CHECK(n.z > 0.9F);  // Smooth normals are weighted by the areas of the triangles.
  }
  // Different texture coordinates and materials on both sides of an edge must not split the normals.
  const sim::Mesh seam =
      meshOf(roof + "vt 0 0\nvt 1 1\ns 1\nusemtl a\nf 1/1 2/1 3/1 4/1\nusemtl b\nf 4/2 3/2 5/2 6/2\n");
  CHECK(seam.positions.size() == 8);
  for (std::size_t i = 0; i < seam.positions.size(); ++i)
    if (seam.positions[i].z == 1.0F) CHECK(seam.normals[i].z > 0.9F);
  // For cloth, the mesh keeps the file's vertices, and all normals are smooth.
  const TemporaryFile file("polygons.obj", roof + "f 1 2 3 4\nf 4 3 5 6\n");
  CHECK(sim::importMesh(file.path(), sim::MeshNormals::shared).positions.size() == 6);
  CHECK(sim::importMesh(file.path()).positions.size() == 8);
  checkHas(refusalOf(corners + "s one\nf 1 2 3\n"), "line 5 \"one\", which is no smoothing group");
}

TEST_CASE("OBJ: 100,000 objects, materials and fans around one vertex are read quickly") {
  std::string objects = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", fan = objects;
  for (int i = 0; i < 100'000; ++i) {
    objects += fmt::format("o o{0}\nusemtl m{0}\nf 1 2 3\n", i);
    fan += fmt::format("vt {} 0\nf 1/{} 2 3\n", i, i + 1);
  }
  const auto before = std::chrono::steady_clock::now();
  CHECK(meshOf(objects).indices.size() == 300'000);
  CHECK(meshOf(fan).indices.size() == 300'000);
  // The limit is generous, because an inefficient reader takes 20 s for each mesh.
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(10));
}

}  // namespace simreel::test::polygons_obj
