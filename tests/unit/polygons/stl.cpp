// Tests binary and text STL as programs for computer-aided design and 3D printing write it.
#include "base/error.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace simreel::test::polygons_stl {

namespace {

using Corners = std::vector<glm::vec3>;

sim::Mesh meshOf(const std::string& bytes, sim::MeshNormals normals = sim::MeshNormals::shown) {
  const TemporaryFile file("polygons.stl", bytes);
  return sim::importMesh(file.path(), normals);
}

std::string refusalOf(const std::string& bytes) {
  try {
    static_cast<void>(meshOf(bytes));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::inputOutput);
    return error.what();
  }
  return "nothing was refused";
}

void addWord(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> 8 * k & 255U);
}

std::string binary(const Corners& corners, const std::string& title = "made by a test",
                   char attribute = 0) {
  std::string bytes = title;
  bytes.resize(80);
  addWord(bytes, static_cast<std::uint32_t>(corners.size() / 3));
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    for (int k = 0; k < 3; ++k) addWord(bytes, 0);
    for (std::size_t c = i; c < i + 3; ++c)
      for (int k = 0; k < 3; ++k) addWord(bytes, std::bit_cast<std::uint32_t>(corners[c][k]));
    bytes += attribute;
    bytes += '\0';
  }
  return bytes;
}

std::string text(const Corners& corners) {
  std::string all = "solid facet of vertex 1\n";
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    all += "facet normal 0 nan 0\n outer loop\n";
    for (std::size_t c = i; c < i + 3; ++c)
      all += fmt::format("  vertex {} {:e} {}\n", corners[c].x, corners[c].y, corners[c].z);
    all += " endloop\nendfacet\n";
  }
  return all + "endsolid\n";
}

/// Returns two triangles that share the edge from (0, 0, 0) to (0, 0, 1). `degrees`: angle between them.
Corners tent(double degrees) {
  const double half = degrees / 2 * std::numbers::pi / 180;
  const auto x = static_cast<float>(std::cos(half)), y = static_cast<float>(-std::sin(half));
  return {{0, 0, 0}, {0, 0, 1}, {x, y, 0}, {0, 0, 0}, {-x, y, 0}, {0, 0, 1}};
}

Corners cube() {
  Corners corners;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, 1}) {
      const auto place = [&](int u, int v) {
        glm::vec3 p;
        p[axis] = static_cast<float>(side);
        p[(axis + 1) % 3] = static_cast<float>(side == 1 ? u : v);
        p[(axis + 2) % 3] = static_cast<float>(side == 1 ? v : u);
        return p;
      };
      for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        corners.push_back(place(u, v));
    }
  return corners;
}

}  // namespace

TEST_CASE("STL: binary and text give the same mesh") {
  const sim::Mesh one = meshOf(binary(cube())), other = meshOf(text(cube()));
  CHECK(one.positions == other.positions);
  CHECK(one.normals == other.normals);
  CHECK(one.indices == other.indices);
  CHECK(one.indices.size() == 36);
  CHECK(one.uvs.empty());
}

TEST_CASE("STL: a cube has flat faces, and eight vertices where normals are shared") {
  const sim::Mesh shown = meshOf(binary(cube()));
  CHECK(shown.positions.size() == 24);
  for (std::size_t i = 0; i < shown.positions.size(); ++i) {
    const glm::vec3 n = shown.normals[i], out = shown.positions[i] - 0.5F;
    CHECK(std::abs(n.x) + std::abs(n.y) + std::abs(n.z) == doctest::Approx(1));
    CHECK(n.x * out.x + n.y * out.y + n.z * out.z == doctest::Approx(0.5));
  }
  CHECK(meshOf(binary(cube()), sim::MeshNormals::shared).positions.size() == 8);
}

TEST_CASE("STL: faces are smooth up to an angle of 30 degrees") {
  const sim::Mesh smooth = meshOf(binary(tent(29)));
  CHECK(smooth.positions.size() == 4);
  CHECK(smooth.normals[0].y == doctest::Approx(1));
  const sim::Mesh flat = meshOf(binary(tent(31)));
  CHECK(flat.positions.size() == 6);
  CHECK(flat.normals[0].y == doctest::Approx(std::cos(15.5 * std::numbers::pi / 180)));
}

TEST_CASE("STL: a vertex of more than 256 faces keeps the normals of its faces") {
  Corners cone;
  const auto rim = [](int i) {
    const double angle = i * 2 * std::numbers::pi / 300;
    return glm::vec3(std::cos(angle), 0, -std::sin(angle));
  };
  for (int i = 0; i < 300; ++i)
    for (const glm::vec3& p : {glm::vec3(0, 0.1F, 0), rim(i), rim(i + 1)}) cone.push_back(p);
  CHECK(meshOf(binary(cone)).positions.size() >= 600);
}

TEST_CASE("STL: binary files may start with \"solid\", and texts have any case and line end") {
  CHECK(meshOf(binary(cube(), "solid cube")).indices.size() == 36);
  std::string upper;
  for (const char c : text(tent(60)))
    upper += c == '\n' ? std::string("\r\n") : std::string(1, static_cast<char>(std::toupper(c)));
  CHECK(meshOf(upper).indices.size() == 6);
  CHECK(meshOf(text(tent(60)) + text(cube())).indices.size() == 42);
  std::string line = text(tent(60));
  std::replace(line.begin(), line.end(), '\n', ' ');
  CHECK(meshOf(line).indices.size() == 6);
  CHECK(meshOf("\xEF\xBB\xBF" + text(tent(60))).indices.size() == 6);
}

TEST_CASE("STL: what is not used is named") {
  CHECK(meshOf(binary(cube())).ignored.empty());
  CHECK(meshOf(binary(cube(), "COLOR=", 1)).ignored.size() == 1);
  CHECK(meshOf(binary(cube()) + "xyz").undrawn ==
        std::vector<std::string>{"3 bytes after its last triangle"});
}

TEST_CASE("STL: a damaged file is refused in one line") {
  const std::string whole = binary(cube()), words = text(tent(60));
  checkHas(refusalOf(whole.substr(0, whole.size() - 1)),
           "is cut off: its header announces 12 triangles, and it has the bytes of 11");
  checkHas(refusalOf(whole.substr(0, 83)), "is shorter than a header");
  checkHas(refusalOf(words.substr(0, words.find(" endloop"))), "ends in the middle of a facet");
  checkHas(refusalOf("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 zero\n"),
           "has an invalid line 4 (expected three numbers)");
  checkHas(refusalOf("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n"),
           "has an invalid line 5 (a facet has three corners, not 1)");
  checkHas(refusalOf("solid x\nendsolid x\n"), "holds no triangle");
  checkHas(refusalOf("solid x\nthese are words\n"), "has an invalid line 2");
  checkHas(
      refusalOf("<!DOCTYPE html><html><head><title>Not found</title></head><body>This page is not there"),
      "is a text that does not start with \"solid\"");
  checkHas(refusalOf(binary({{0, 0, NAN}, {1, 0, 0}, {0, 1, 0}})), "not finite");
}

}  // namespace simreel::test::polygons_stl
