// Tests PLY as specified by Turk and as other programs write it.
#include "base/error.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>

namespace simreel::test::polygons_ply {

namespace {

sim::Mesh meshOf(const std::string& text) {
  const TemporaryFile file("polygons.ply", text);
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

const std::string place = "property float x\nproperty float y\nproperty float z\n";
const std::string threeCorners = "element vertex 3\n" + place;
const std::string oneFace = "element face 1\nproperty list uchar int vertex_indices\n";

std::string text(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

template <class Value>
std::string bytesOf(Value value, bool bigEndian) {
  auto bits = std::bit_cast<std::conditional_t<sizeof(Value) == 4, std::uint32_t, std::uint8_t>>(value);
  std::string bytes;
  for (std::size_t i = 0; i < sizeof bits; ++i) {
    const char byte = static_cast<char>(bits >> 8 * i & 255U);
    bytes = bigEndian ? byte + bytes : bytes + byte;
  }
  return bytes;
}

/// Returns a binary PLY file with a triangle. `x`: x of the first vertex.
std::string binary(bool bigEndian, float x, const std::string& lineEnd = "\n") {
  std::string header = std::string("ply\nformat binary_") + (bigEndian ? "big" : "little") +
                       "_endian 1.0\n" + threeCorners + oneFace + "end_header\n";
  std::string all;
  for (const char c : header) all += c == '\n' ? lineEnd : std::string(1, c);
  for (const float v : {x, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F}) all += bytesOf(v, bigEndian);
  all += bytesOf(std::uint8_t{3}, bigEndian);
  for (const std::int32_t i : {0, 1, 2}) all += bytesOf(i, bigEndian);
  return all;
}

}  // namespace

TEST_CASE("PLY: binary data may start with line-break bytes") {
  for (const bool bigEndian : {false, true})
    for (const char* lineEnd : {"\n", "\r\n", "\r"})
      for (const std::uint32_t first : {10U, 13U, 32U, 0x3f000a0aU, 0x0a0d003fU}) {
        const std::uint32_t bits = bigEndian ? first << 24U | 1U : first;
        const auto x = std::bit_cast<float>(bits);
        const sim::Mesh mesh = meshOf(binary(bigEndian, x, lineEnd));
        REQUIRE(mesh.positions.size() == 3);
        CHECK(mesh.positions[0].x == x);
        CHECK(mesh.positions[2].y == 1.0F);
      }
}

TEST_CASE("PLY: all triangles of strips are read with the right orientation") {
  const std::string header =
      "element vertex 6\n" + place + "element tristrips 2\nproperty list int int vertex_indices\n";
  const sim::Mesh mesh =
      meshOf(text(header, "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n4 0 1 2 3\n9 2 3 4 -1 3 5 4 4 -1\n"));
  CHECK(mesh.indices == std::vector<unsigned>{0, 1, 2, 2, 1, 3, 2, 3, 4, 3, 5, 4});
  for (const glm::vec3& n : mesh.normals) CHECK(n == glm::vec3(0, 0, 1));
}

TEST_CASE("PLY: elements may come in any order, and comments anywhere in the header") {
  CHECK(meshOf(text(oneFace + threeCorners, "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n")).positions[1].x == 1.0F);
  const std::string noted =
      "element vertex 3\ncomment Points\n" + place + "obj_info 7\n" + oneFace + "comment\n";
  CHECK(meshOf(text(noted, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")).indices.size() == 3);
  const sim::Mesh mesh = meshOf(text(
      "element camera 1\nproperty list uchar float f\nproperty int n\nelement edge 1\nproperty int a\n" +
          threeCorners + oneFace,
      "2 0.5 0.5 7\n3\n\n0 0\n0\n1 0 0\n0 1 0\n3 0\n1 2\n"));
  CHECK(mesh.indices.size() == 3);
  CHECK(mesh.undrawn == std::vector<std::string>{"elements \"camera\" (1)", "edges (1)"});
}

TEST_CASE("PLY: vertex normals, texture coordinates and colours of any type are read") {
  const std::string header =
      "element vertex 3\n" + place +
      "property float nx\nproperty float ny\nproperty float nz\nproperty double s\nproperty double t\n"
      "property ushort red\nproperty ushort green\nproperty ushort blue\n" +
      oneFace;
  const sim::Mesh mesh = meshOf(text(
      header, "0 0 0 0 3 4 0.25 0.25 65535 0 0\n1 0 0 0 3 4 0 0 0 0 0\n0 1 0 0 3 4 0 0 0 0 0\n3 0 1 2\n"));
  CHECK(glm::length(mesh.normals[0] - glm::vec3(0, 0.6F, 0.8F)) < 1e-6F);
  CHECK(mesh.uvs[0] == glm::vec2(0.25F, 0.75F));
  CHECK(mesh.colors[0] == glm::vec3(1, 0, 0));
}

TEST_CASE("PLY: face colours and textures are reported as not drawn") {
  const sim::Mesh mesh = meshOf(text("comment TextureFile t.png\n" + threeCorners + oneFace +
                                         "property uchar red\nproperty list uchar float texcoord\n",
                                     "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 2 0 0\n"));
  CHECK(mesh.ignored == std::vector<std::string>{"the colours of its faces",
                                                 "the texture coordinates of its faces",
                                                 "TextureFile t.png"});
}

TEST_CASE("PLY: data that does not match the header is refused with its place") {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n";
  checkHas(refusalOf(text(threeCorners + oneFace, "0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n")),
           "line 10 more numbers than the header has properties");
  checkHas(refusalOf(text(threeCorners + oneFace, "0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n")), "line 10 \"x\"");
  checkHas(refusalOf(text(threeCorners + oneFace, "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n")), "not finite");
  checkHas(refusalOf(text(threeCorners + oneFace, body + "3 0 1 3\n")), "a face with vertex 3 of 3");
  checkHas(refusalOf(text(threeCorners + oneFace, body + "3 0 1 -1\n")), "a face with vertex -1");
  checkHas(refusalOf(text(threeCorners + oneFace, body + "3 0 1\n")), "is cut off at face 0 of 1");
  checkHas(refusalOf(text(threeCorners + oneFace, body + "-3 0 1 2\n")), "a list of -3 values");
  checkHas(refusalOf(text(threeCorners, body)), "\"particles\" draw its points");
  checkHas(refusalOf(text("element vertex 3\nproperty float x\nproperty float y\n" + oneFace,
                          "0 0\n0 0\n0 0\n3 0 1 2\n")),
           "vertices without x, y and z");
  std::string cut = binary(false, 0);
  cut.resize(cut.size() - 1);
  checkHas(refusalOf(cut), "is cut off at face 0 of 1");
  CHECK(meshOf(text(threeCorners + oneFace, body + "3 0 1 2\n3 0 1 2\n")).undrawn ==
        std::vector<std::string>{"8 bytes after its last element"});
}

TEST_CASE("PLY: other versions, and list lengths that are not integers, are refused") {
  const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  CHECK(meshOf(text(threeCorners + oneFace, body)).indices.size() == 3);
  checkHas(refusalOf("ply\nformat ascii 2.0\n" + threeCorners + oneFace + "end_header\n" + body),
           "has in line 2 \"format ascii 2.0\"; only version 1.0 is read");
  checkHas(refusalOf(text(threeCorners + "element face 1\nproperty list float int vertex_indices\n", body)),
           "\"property list float int vertex_indices\"; a list's length is a whole number");
}

}  // namespace simreel::test::polygons_ply
