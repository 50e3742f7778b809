// Tests mesh files. Their supported content must be read, and each error must give a clear one-line
// message.
#include "sim/mesh/file/mesh_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using simreel::test::TemporaryFile;

namespace {

std::string failure(const std::filesystem::path& path, ExitCode code) {
  try {
    static_cast<void>(sim::loadMesh(path));
  } catch (const UserError& error) {
    CHECK(error.code() == code);
    const std::string message = error.what();
    CHECK(message.find(path.string()) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
  return "no failure";
}

std::string failure(const std::string& name, const std::string& text) {
  const TemporaryFile file(name, text);
  return failure(file.path(), ExitCode::inputOutput);
}

/// Checks that the mesh is a square in the xy plane that faces +z.
void checkSquare(const sim::Mesh& mesh) {
  REQUIRE(mesh.indices.size() == 6);
  REQUIRE(mesh.normals.size() == mesh.positions.size());
  float area = 0;
  for (std::size_t i = 0; i < 6; i += 3) {
    const glm::vec3 a = mesh.positions.at(mesh.indices[i]);
    const glm::vec3 normal =
        glm::cross(mesh.positions.at(mesh.indices[i + 1]) - a, mesh.positions.at(mesh.indices[i + 2]) - a);
    CHECK(normal.z > 0);
    area += 0.5F * glm::length(normal);
  }
  CHECK(area == doctest::Approx(1));
  for (const glm::vec3& n : mesh.normals) CHECK(glm::length(n - glm::vec3(0, 0, 1)) < 1e-5F);
}

const char* const asciiSquare =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

}  // namespace

TEST_CASE("OBJ, PLY and glTF files of one square give equal meshes with computed normals") {
  const TemporaryFile obj("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  checkSquare(sim::loadMesh(obj.path()));
  CHECK(sim::loadMesh(obj.path()).uvs.empty());
  const TemporaryFile ply("square.PLY", asciiSquare);
  checkSquare(sim::loadMesh(ply.path()));
  // Two triangles face +z. Their node mirrors along x, which must not turn them inside out.
  const TemporaryFile gltf(
      "square.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[-1,1,1]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":4}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":72}],"buffers":[{"byteLength":72,"uri":"data:application/octet-stream;base64,)"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAA"
      "AAAAAAAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAA"
      R"("}]})");
  const sim::Mesh mirrored = sim::loadMesh(gltf.path());
  REQUIRE(mirrored.indices.size() == 6);
  for (const glm::vec3& p : mirrored.positions) CHECK(p.x <= 0);
  for (const glm::vec3& n : mirrored.normals) CHECK(n.z == doctest::Approx(1));
}

TEST_CASE("normals and texture coordinates in a file are kept") {
  const TemporaryFile obj(
      "lit.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 0.5 0\nvt 0 0.25\nvn 0 3 4\nf 1/1/1 2/2/1 3/3/1\n");
  const sim::Mesh mesh = sim::loadMesh(obj.path());
  REQUIRE(mesh.indices.size() == 3);
  for (const glm::vec3& n : mesh.normals) CHECK(glm::length(n - glm::vec3(0, 0.6F, 0.8F)) < 1e-5F);
  REQUIRE(mesh.uvs.size() == mesh.positions.size());
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(mesh.uvs[i].x == doctest::Approx(0.5F * mesh.positions[i].x));
    CHECK(mesh.uvs[i].y == doctest::Approx(1 - 0.25F * mesh.positions[i].y));
  }
}

TEST_CASE("mesh: each invalid line of a PLY header is reported") {
  const auto with = [](const std::string& old, const std::string& text) {
    std::string changed = asciiSquare;
    const auto at = changed.find(old);
    REQUIRE(at != std::string::npos);
    return failure("head.ply", changed.replace(at, old.size(), text));
  };
  simreel::test::checkHas(with("end_header\n", "end_headerin\n"),
                          "line 9 \"end_headerin\", which is no line of a PLY header");
  simreel::test::checkHas(with("property float x\n", std::string("\0\0property float x\n", 19)),
                          R"(line 4 "\x00\x00property float x", which)");
  simreel::test::checkHas(with("list uchar", "list uch"), "line 8 \"property list uch int");
  simreel::test::checkHas(with("float y", "real y"), "line 5 ");
  simreel::test::checkHas(with("ascii 1.0", "ascii"), "line 2 ");
  simreel::test::checkHas(with("ascii", "text"), "line 2 ");
  simreel::test::checkHas(with("ply\n", "PLY\n"), "line 1 ");
  simreel::test::checkHas(with("ply\n", "end_header\n"), "line 1 ");
  simreel::test::checkHas(with("vertex 4", "vertex 4x"), "line 3 ");
  simreel::test::checkHas(with("vertex 4", "vertex 4000"), "promises 4000 elements");
  simreel::test::checkHas(with("vertex 4", "vertex 99999999999999999999"),
                          "promises 99999999999999999999 elements");
  simreel::test::checkHas(failure("head.ply", "ply\nformat ascii 1.0\n"), "has no \"end_header\"");
  CHECK(with("element face", "comment of \xff\nobj_info 7\nelement face") == "no failure");
  std::string crlf;
  for (const char c : std::string(asciiSquare)) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const TemporaryFile file("crlf.ply", crlf);
  checkSquare(sim::loadMesh(file.path()));
}

TEST_CASE("an unusable mesh is reported in one line") {
  CHECK(failure("/nowhere/ball.obj", ExitCode::usage) != "no failure");
  CHECK(failure("/nowhere/ball.fbx", ExitCode::usage).find(".obj, .ply, .stl, .gltf and .glb") !=
        std::string::npos);
  CHECK(failure("points.obj", "v 0 0 0\nv 1 0 0\n") != "no failure");
  CHECK(failure("empty.obj", "") != "no failure");
  CHECK(failure("words.ply", "these are words\n") != "no failure");
  CHECK(failure("words.gltf", "{\"asset\": 7") != "no failure");
  CHECK(failure("words.glb", "glTF and nothing else") != "no failure");
  CHECK(failure("index.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n") != "no failure");
  std::string cut = asciiSquare;
  cut.resize(cut.size() - 24);
  CHECK(failure("cut.ply", cut) != "no failure");
  std::string beyond = asciiSquare;
  beyond.replace(beyond.rfind("2 3"), 3, "2 7");
  CHECK(failure("beyond.ply", beyond).find("vertex 7 of 4") != std::string::npos);
  CHECK(failure("far.obj", "v 0 0 0\nv 1e20 0 0\nv 1 1 0\nf 1 2 3\n").find("1e9 m") != std::string::npos);
}
