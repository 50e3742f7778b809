// Tests broken mesh files, which are generated here. For any content, the reader must return a valid mesh
// or a clear one-line error.
#include "base/error.hpp"
#include "base/file.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <unistd.h>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

namespace fs = std::filesystem;

struct Folder {
  Folder() : path(fs::temp_directory_path() / ("simreel_corpus_" + std::to_string(::getpid()))) {
    fs::create_directories(path / "inner");
  }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path path;
};

/// Returns "" for a valid mesh, or the error message. Any other result fails the test.
std::string read(const fs::path& file, const std::string& text) {
  writeFileAtomically(file, text);
  try {
    const sim::Mesh mesh = sim::loadMesh(file);
    CHECK(mesh.indices.size() % 3 == 0);
    CHECK(mesh.normals.size() == mesh.positions.size());
    CHECK((mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size()));
    bool sound = true;
    for (const unsigned i : mesh.indices) sound = sound && i < mesh.positions.size();
    for (const glm::vec3& p : mesh.positions)
      sound = sound && std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e9F;
    CHECK(sound);
    return "";
  } catch (const UserError& error) {
    const std::string message = error.what();
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find(file.string()) != std::string::npos);
    return message;
  }
}

const std::string squareObj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1 "
    "4/2/1\n";
const std::string squarePly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";

/// Returns a glTF triangle with 16-bit indices. `uri`: address of a buffer of 36 + 6 bytes. `count`: number
/// of vertices.
std::string triangleGltf(const std::string& uri, const std::string& count = "3") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":)" +
         count +
         R"(,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],)"
         R"("buffers":[{"byteLength":42,"uri":")" +
         uri + "\"}]}";
}
const std::string triangleUri =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA";

std::uint32_t next(std::uint32_t& state) {
  state = state * 1664525U + 1013904223U;
  return state >> 8U;
}

}  // namespace

TEST_CASE("whole files of the corpus are read: 16-bit glTF indices, relative OBJ indices") {
  const Folder folder;
  CHECK(read(folder.path / "a.obj", squareObj).empty());
  CHECK(read(folder.path / "a.ply", squarePly).empty());
  CHECK(read(folder.path / "a.gltf", triangleGltf(triangleUri)).empty());
  CHECK(sim::loadMesh(folder.path / "a.gltf").positions.size() == 3);
  CHECK(read(folder.path / "b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\n").empty());
  CHECK(sim::loadMesh(folder.path / "b.obj").indices.size() == 3);
  // The files contain degenerate triangles, and three triangles that share an edge.
  CHECK(read(folder.path / "c.obj",
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 2 5\nf 1 1 2\n")
            .empty());
}

TEST_CASE("wrong counts and names in a mesh file are refused in one line") {
  const Folder folder;
  const fs::path inner = folder.path / "inner";
  const auto says = [](const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos;
  };
  CHECK(!read(inner / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -9 -2 -1\n").empty());
  CHECK(!read(inner / "b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 4000000000\n").empty());
  CHECK(!read(inner / "c.obj", "v 0 0 0\nv nan 0 0\nv 1 inf 0\nf 1 2 3\n").empty());
  std::string absurd = squarePly;
  absurd.replace(absurd.find("vertex 4"), 8, "vertex 4000000000");
  CHECK(says(read(inner / "d.ply", absurd), "4000000000 elements"));
  absurd.replace(absurd.find("4000000000"), 10, "99999999999999999999999");
  CHECK(says(read(inner / "d.ply", absurd), "elements in"));
  CHECK(says(read(inner / "e.gltf", triangleGltf(triangleUri, "4000000000")), "count"));
  CHECK(says(read(inner / "e.gltf", triangleGltf(triangleUri, "-3")), "count"));
  CHECK(!read(inner / "e.gltf", triangleGltf(triangleUri, "4")).empty());
  // The buffer is outside the folder. It is reached through ".." and through a link.
  const std::string bytes(42, '\0');
  writeFileAtomically(folder.path / "secret.bin", bytes);
  CHECK(says(read(inner / "f.gltf", triangleGltf("../secret.bin")), "outside its folder"));
  fs::create_symlink(folder.path / "secret.bin", inner / "link.bin");
  CHECK(says(read(inner / "f.gltf", triangleGltf("link.bin")), "outside its folder"));
  CHECK(says(read(inner / "g.obj", "mtllib ../secret.bin\n" + squareObj.substr(13)), "outside its folder"));
  CHECK(!read(inner / "h.gltf", triangleGltf("missing.bin")).empty());
}

TEST_CASE("truncated and damaged mesh files give a valid mesh or a one-line error") {
  const Folder folder;
  struct Whole {
    const char* extension;
    std::string text;
  };
  std::uint32_t random = 7;
  for (const Whole& whole :
       {Whole{".obj", squareObj}, {".ply", squarePly}, {".gltf", triangleGltf(triangleUri)}}) {
    const fs::path file = folder.path / (std::string("x") + whole.extension);
    for (std::size_t length = 0; length < whole.text.size(); length += 7)
      static_cast<void>(read(file, whole.text.substr(0, length)));
    for (int round = 0; round < 60; ++round) {
      std::string damaged = whole.text;
      for (int hit = 0; hit < 1 + round % 3; ++hit)
        damaged[next(random) % damaged.size()] = "0123456789-.e{}[]\",x\n "[next(random) % 22];
      static_cast<void>(read(file, damaged));
    }
  }
}
