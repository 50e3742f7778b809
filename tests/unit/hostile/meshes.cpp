// Tests meshes designed to crash their reader or to exhaust memory or time. Also tests the child process
// that isolates a crash.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/isolated.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"
#include "unit/hostile/hostile.hpp"

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::test;

namespace {

std::string refusalOf(const std::string& name, const std::string& text) {
  const TemporaryFile file(name, text);
  return refusal([&] { static_cast<void>(sim::loadMesh(file.path())); });
}

/// Returns a glTF file with a triangle whose 36 position bytes are zero except two. `nodes` and `count`
/// (number of vertices) are inserted.
std::string gltf(const std::string& nodes, const std::string& count = "3", const std::string& more = "") {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0})" + more +
         R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":)" + count +
         R"(,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
         R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
}

/// Returns `count` nodes. `child`: function that returns the children of a node, given the index of the
/// next node. The last node has the mesh.
template <class Child>
std::string row(std::size_t count, const Child& child) {
  std::string nodes = "[";
  for (std::size_t i = 1; i < count; ++i) nodes += R"({"children":[)" + child(std::to_string(i)) + "]},";
  return nodes + R"({"mesh":0}])";
}

}  // namespace

TEST_CASE("glTF node graphs that are exponential, cyclic or a million levels deep are refused") {
  CHECK(refusalOf("whole.gltf", gltf(R"([{"mesh":0}])")) == "nothing was refused");
  const auto once = [](const std::string& next) { return next; };
  const auto twice = [](const std::string& next) { return next + "," + next; };
  CHECK(refusalOf("row.gltf", gltf(row(200, once))) == "nothing was refused");
  checkHas(refusalOf("double.gltf", gltf(row(64, twice))), "two parents");
  checkHas(refusalOf("deep.gltf", gltf(row(100'000, once))), "nests its nodes");
  checkHas(refusalOf("deeper.gltf", gltf(row(1'000'000, once))), "500000 objects and lists");
  checkHas(refusalOf("circle.gltf", gltf(R"([{"children":[1]},{"children":[0],"mesh":0}])")),
           "two parents");
  checkHas(refusalOf("self.gltf", gltf(R"([{"children":[0]}])")), "two parents");
  checkHas(refusalOf("nobody.gltf", gltf(R"([{"children":[1]}])")), "names number 1 of its 1 nodes");
  checkHas(refusalOf("json.gltf", R"({"asset":{"version":"2.0"},"extras":)" + times(1'000'000, "[") +
                                      times(1'000'000, "]") + "}"),
           "nested deeper");
}

TEST_CASE("a glTF that declares more elements than its bytes hold is refused before reading them") {
  const std::string node = R"([{"mesh":0}])";
  checkHas(refusalOf("four.gltf", gltf(node, "4")), "count is 4: 48 bytes, of which its view holds 36");
  checkHas(refusalOf("many.gltf", gltf(node, "20000000")), "count");
  checkHas(refusalOf("none.gltf", gltf(node, "0")), "count must be between");
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = gltf(node);
    text.replace(text.find(from), from.size(), to);
    return refusalOf("changed.gltf", text);
  };
  checkHas(changed(R"("byteLength":36})", R"("byteLength":40})"), "a buffer of 36");
  checkHas(changed(R"("byteLength":36,)", R"("byteLength":4000,)"), "of which 36 are there");
  checkHas(changed(R"("byteLength":36})", R"("byteOffset":18446744073709551615,"byteLength":36})"),
           "byteOffset");
  checkHas(changed(R"("VEC3")", R"("VEC2")"), "vectors of 2 where 3");
  checkHas(changed("5126", "5125"), "whole numbers where vertices");
  // The mesh has a few vertices and a million primitives. It is small as a file but expensive to draw.
  checkHas(
      refusalOf("parts.gltf", gltf(R"([{"mesh":0}])", "3",
                                   "}" + times(200'000, R"(},{"attributes":{"POSITION":0})").substr(1))),
      "parts");
}

TEST_CASE("glTF strips, fans, sparse values, normalised numbers and binary files are read") {
  const auto mesh = [](const std::string& name, const std::string& text) {
    const TemporaryFile file(name, text);
    return sim::importMesh(file.path());
  };
  // The positions are the four corners of a square as normalized unsigned bytes (255 is 1). They are also
  // the texture coordinates.
  const std::string square("\0\0\0\0\xff\0\0\0\0\xff\0\0\xff\xff\0\0", 16);
  const auto document = [&](const std::string& mode, const std::string& buffer) {
    return R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],"scenes":[{"nodes":[0]}],)"
           R"("nodes":[{"mesh":0,"translation":[0,0,3],"scale":[2,2,2]}],"meshes":[{"primitives":[{"mode":)" +
           mode +
           R"(,"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],"accessors":[)"
           R"({"bufferView":0,"componentType":5121,"normalized":true,"count":4,"type":"VEC3"},)"
           R"({"bufferView":0,"componentType":5121,"normalized":true,"count":4,"type":"VEC2"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":16,"byteStride":4}],"buffers":[{)" +
           buffer + R"("byteLength":16}]})";
  };
  const auto binary = [&](std::string json) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto word = [](std::size_t value) {
      return std::string{static_cast<char>(value), static_cast<char>(value >> 8),
                         static_cast<char>(value >> 16), 0};
    };
    return "glTF" + word(2) + word(28 + json.size() + square.size()) + word(json.size()) + "JSON" + json +
           word(square.size()) + std::string("BIN\0", 4) + square;
  };
  const sim::Mesh strip = mesh("strip.glb", binary(document("5", "")));
  REQUIRE(strip.positions.size() == 4);
  CHECK(strip.positions[3] == glm::vec3(2, 2, 3));
  CHECK(strip.uvs[1] == glm::vec2(1, 0));  // v points down in the mesh, as in the file.
  CHECK(strip.uvs[2] == glm::vec2(0, 1));
  CHECK(strip.indices == std::vector<unsigned>{0, 1, 2, 1, 3, 2});
  for (const glm::vec3& n : strip.normals) CHECK(n == glm::vec3(0, 0, 1));
  const sim::Mesh fan = mesh("fan.glb", binary(document("6", "")));
  CHECK(fan.indices ==
        std::vector<unsigned>{0, 1, 2, 3, 4, 5});  // The two triangles face opposite directions.
  CHECK(fan.positions[5] == strip.positions[3]);
  CHECK(fan.normals[5] == glm::vec3(0, 0, -1));
  checkHas(refusalOf("cut.glb", binary(document("5", "")).substr(0, 400)), "cut off");
  std::string draco = gltf(R"([{"mesh":0}])");
  draco.insert(1, R"("extensionsRequired":["KHR_draco_mesh_compression"],)");
  checkHas(refusalOf("draco.gltf", draco), "needs the extension KHR_draco_mesh_compression");
  // The first corner of the triangle is moved onto the second.
  std::string sparse = gltf(R"([{"mesh":0}])");
  sparse.replace(sparse.find(R"("type":"VEC3")"), 13,
                 R"("type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},)"
                 R"("values":{"bufferView":0,"byteOffset":12}})");
  const std::size_t views = sparse.find(R"("bufferViews":[)") + 15;
  sparse.insert(sparse.find(']', views), R"(,{"buffer":0,"byteOffset":0,"byteLength":1})");
  const sim::Mesh moved = mesh("sparse.gltf", sparse);
  REQUIRE(moved.positions.size() == 2);
  CHECK(moved.positions[0] == glm::vec3(1, 0, 0));
}

TEST_CASE("faces of 900,000 corners are refused") {
  std::string obj, ply, face = "f", list = "900000";
  for (int i = 0; i < 900'000; ++i) {
    const std::string line = std::to_string(i % 1000) + " " + std::to_string(i / 1000) + " 0\n";
    obj += "v " + line;
    ply += line;
    face += " " + std::to_string(i + 1);
    list += " " + std::to_string(i);
  }
  checkHas(refusalOf("face.obj", obj + face + "\n"), "corners");
  checkHas(refusalOf("face.ply",
                     "ply\nformat ascii 1.0\nelement vertex 900000\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uint int vertex_indices\n"
                     "end_header\n" +
                         ply + list + "\n"),
           "corners");
}

TEST_CASE("corners of an OBJ face are counted across continued lines, up to the limit") {
  const std::string vertices = "# \\\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto face = [&](int corners) {
    std::string text = vertices + "  f";
    for (int i = 0; i < corners; ++i)
      text += " " + std::to_string(i % 3 + 1) + "//" + (i % 1000 == 999 ? " \\\r\n" : "");
    return text + "\nf 1 2 3\n";
  };
  checkHas(refusalOf("face.obj", face(10'001)), "face of 10001 corners (line 5), more than 10000");
  CHECK_FALSE(has(refusalOf("face.obj", face(10'000)), "corners"));
}

TEST_CASE("pipes as companion files of a mesh do not block") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "simreel-hostile-folder";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const auto read = [&](const char* name, const std::string& text) {
    writeFileAtomically(folder / name, text);
    return refusal([&] { static_cast<void>(sim::loadMesh(folder / name)); });
  };
  std::string text = gltf(R"([{"mesh":0}])");
  const std::size_t uri = text.find("data:");
  text.replace(uri, text.find('"', uri) - uri, "pipe");
  checkHas(read("a.gltf", text), "not a regular file");
  // A material that cannot be read must not affect the triangles.
  CHECK(read("a.obj", "mtllib pipe\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n") == "nothing was refused");
  std::filesystem::remove_all(folder);
}

TEST_CASE("isolated work returns bytes and errors, and its crashes do not affect the process") {
  const ProcessLimits small{std::size_t{64} << 20, 1};
  const auto ended = [&](const std::function<std::string()>& work) {
    try {
      return "gave " + runIsolated(small, work);
    } catch (const UserError&) {
      throw;
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  CHECK(ended([] { return std::string("a\0b", 3); }) == std::string("gave a\0b", 8));
  CHECK(ended([] { return std::string(); }) == "gave ");
  CHECK(runIsolated(small, [] { return std::string(10'000'000, 'x'); }).size() == 10'000'000);
  CHECK_THROWS_WITH_AS(ended([]() -> std::string { fail(ExitCode::device, "no luck"); }), "no luck",
                       UserError);
  CHECK(ended([]() -> std::string { throw std::logic_error("odd"); }) == "failed: odd");
  CHECK(ended([]() -> std::string { ::_exit(3); }) == "crashed");
  int mine = 1;
  CHECK(ended([&] { return std::to_string(++mine); }) == "gave 2");
  CHECK(mine == 1);
  CHECK(ended([]() -> std::string {
          ::kill(::getpid(), SIGKILL);
          return "";
        }) == "crashed (Killed)");
  if (!measured) return;  // Sanitizers handle these signals themselves.
  CHECK(ended([]() -> std::string { std::abort(); }) == "crashed (Aborted)");
  CHECK(ended([]() -> std::string {
          std::raise(SIGSEGV);
          return "";
        }) == "crashed (Segmentation fault)");
  CHECK(ended([] { return std::string(std::size_t{100} << 20, 'x'); }) ==
        "needs more than 64 MiB of memory");
  CHECK(ended([]() -> std::string {
          for (std::atomic<long> turns = 0;; ++turns) {
          }
        }) == "took more than 1 s");
}
