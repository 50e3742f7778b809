// Tests meshes and contours as files, read back by readers of other programs (glTF by assimp).
#include "base/file.hpp"
#include "draw/camera.hpp"
#include "frame/file/contour_file.hpp"
#include "frame/mesh/glb.hpp"

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;

namespace {

/// Returns a tetrahedron with outward faces. One of the vertices is unused.
sim::MeshTable tetrahedron() {
  sim::MeshTable mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {9, 9, 9}, {0, 1, 0}, {0, 0, 1}};
  mesh.normals = {{-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0, 0, 1}};
  mesh.uvs = {{0, 0}, {1, 0}, {7, 7}, {0, 1}, {0.5F, 0.5F}};
  mesh.indices = {0, 3, 1, 0, 1, 4, 0, 4, 3, 1, 3, 4};
  return mesh;
}

}  // namespace

TEST_CASE("binary glTF is read back by assimp") {
  const sim::MeshTable mesh = tetrahedron();
  const std::vector<std::string> comments = {"simreel", "a \"quoted\" word"};
  const std::vector<std::byte> file = frame::encodeGlb(mesh, "solid", comments);
  CHECK(file.size() % 4 == 0);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(
      file.data(), file.size(), aiProcess_ValidateDataStructure | aiProcess_JoinIdenticalVertices, "glb");
  REQUIRE_MESSAGE(scene != nullptr, importer.GetErrorString());
  REQUIRE(scene->mNumMeshes == 1);
  const aiMesh& read = *scene->mMeshes[0];
  CHECK(std::string(read.mName.C_Str()) == "solid");
  CHECK(read.mNumVertices == 4);  // the unused vertex is not written
  REQUIRE(read.mNumFaces == 4);
  for (unsigned f = 0; f < 4; ++f) {
    REQUIRE(read.mFaces[f].mNumIndices == 3);
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned got = read.mFaces[f].mIndices[k];
      const unsigned want = mesh.indices[3 * f + k];
      CHECK(glm::vec3(read.mVertices[got].x, read.mVertices[got].y, read.mVertices[got].z) ==
            mesh.positions[want]);
      CHECK(glm::vec3(read.mNormals[got].x, read.mNormals[got].y, read.mNormals[got].z) ==
            mesh.normals[want]);
      CHECK(read.mTextureCoords[0][got].x == mesh.uvs[want].x);
    }
  }
}

TEST_CASE("a mesh without triangles gives a binary glTF without meshes") {
  const std::vector<std::byte> file = frame::encodeGlb({}, "nothing", {});
  const std::string text(reinterpret_cast<const char*>(file.data()) + 20, file.size() - 20);
  const auto document = nlohmann::json::parse(text);
  CHECK(!document.contains("meshes"));
  CHECK(!document.contains("buffers"));
}

TEST_CASE("contours are written as loops without points on straight lines") {
  sim::ContourLines lines;
  lines.size = {5, 5};
  // A square of side 2 with a point in the middle of each side, and a triangle of another level. Their
  // points are interleaved.
  lines.points = {{1, 1}, {0, 0}, {2, 1}, {3, 1}, {1, 0}, {3, 3}, {1, 3}, {0, 1}, {1, 2}};
  lines.next = {2, 4, 3, 5, 7, 6, 8, 1, 0};
  lines.levels = {1, 2, 1, 1, 2, 1, 1, 2, 1};
  const auto loops = frame::contourLoops(lines);
  REQUIRE(loops.size() == 2);
  CHECK(loops[0].level == 1);
  CHECK(loops[0].points == std::vector<glm::vec2>{{1, 1}, {3, 1}, {3, 3}, {1, 3}});
  CHECK(loops[1].level == 2);
  CHECK(loops[1].points.size() == 3);
  const std::string svg = frame::encodeSvg(lines, lines.size, {});
  CHECK(svg.find("d=\"M1 1 L3 1 L3 3 L1 3 Z \"") != std::string::npos);
  const std::vector<glm::vec2> path = {{0, 1}, {2, 1}};
  const auto document = nlohmann::json::parse(frame::encodeGeoJson(lines, path, {}));
  REQUIRE(document["features"].size() == 5);
  CHECK(document["features"][0]["geometry"]["coordinates"].front() ==
        document["features"][0]["geometry"]["coordinates"].back());
  CHECK(document["features"][3]["properties"]["name"] == "entrance");
  CHECK(document["features"][3]["geometry"]["coordinates"] == nlohmann::json({0.0, -1.0}));
}

TEST_CASE("a path camera is placed by arc length and looks along the path") {
  const std::vector<glm::vec3> path = {{0, 0, 0}, {3, 0, 0}, {3, 0, 1}};
  scene::Follow follow;
  follow.height = 2;
  follow.ahead = 1;
  follow.progress = scene::Animated<float>({{0, 0.0F}, {1, 1.0F}}, scene::Ease::linear);
  CHECK(draw::standOn(path, follow, 0).eye == glm::vec3(0, 2, 0));
  CHECK(draw::standOn(path, follow, 0.5).eye == glm::vec3(2, 2, 0));
  CHECK(draw::standOn(path, follow, 1).eye == glm::vec3(3, 2, 1));
  const draw::Stand end = draw::standOn(path, follow, 1);
  CHECK(end.target.z > 1.2F);  // beyond its end, the path continues straight
  CHECK(end.target.x == doctest::Approx(3));
  CHECK(draw::standOn({{1, 2, 3}}, follow, 0.7).eye == glm::vec3(1, 4, 3));
}
