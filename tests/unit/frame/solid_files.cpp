// Tests meshes and contours as files, which are read back by readers of other programs (glTF by assimp).
#include "base/file.hpp"
#include "draw/camera.hpp"
#include "frame/file/contour_file.hpp"
#include "frame/image.hpp"
#include "frame/mesh/glb.hpp"
#include "glb_file.hpp"
#include "help.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/material.h>
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
  const std::vector<std::byte> file =
      frame::encodeGlb(std::array{frame::GlbObject{"solid", mesh}}, comments);
  CHECK(file.size() % 4 == 0);
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(
      file.data(), file.size(), aiProcess_ValidateDataStructure | aiProcess_JoinIdenticalVertices, "glb");
  REQUIRE_MESSAGE(scene != nullptr, importer.GetErrorString());
  REQUIRE(scene->mNumMeshes == 1);
  const aiMesh& read = *scene->mMeshes[0];
  CHECK(std::string(read.mName.C_Str()) == "solid");
  CHECK(read.mNumVertices == 4);  // The unused vertex is not written.
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

TEST_CASE("the objects of a scene are nodes of one binary glTF, which assimp reads back") {
  sim::MeshTable moved = tetrahedron();
  for (glm::vec3& position : moved.positions) position.x += 3;
  const std::array<frame::GlbObject, 3> objects = {
      frame::GlbObject{"solid", tetrahedron()}, {"nothing"}, {"moved", moved}};
  const std::vector<std::byte> file = frame::encodeGlb(objects, {});
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFileFromMemory(file.data(), file.size(), aiProcess_ValidateDataStructure, "glb");
  REQUIRE_MESSAGE(scene != nullptr, importer.GetErrorString());
  REQUIRE(scene->mRootNode->mNumChildren == 3);
  CHECK(scene->mNumMeshes == 2);
  for (unsigned i = 0; i < 3; ++i) {
    const aiNode& node = *scene->mRootNode->mChildren[i];
    CHECK(std::string(node.mName.C_Str()) == objects[i].name);
    REQUIRE(node.mNumMeshes == (i == 1 ? 0 : 1));
    if (i == 1) continue;
    const aiMesh& read = *scene->mMeshes[node.mMeshes[0]];
    float minimum = read.mVertices[0].x;
    for (unsigned k = 0; k < read.mNumVertices; ++k) minimum = std::min(minimum, read.mVertices[k].x);
    CHECK(minimum == (i == 0 ? 0.0F : 3.0F));
  }
}

TEST_CASE("a mesh without triangles gives a binary glTF without meshes") {
  const std::vector<std::byte> file = frame::encodeGlb(std::array{frame::GlbObject{"nothing"}}, {});
  const std::string text(reinterpret_cast<const char*>(file.data()) + 20, file.size() - 20);
  const auto document = nlohmann::json::parse(text);
  CHECK(!document.contains("meshes"));
  CHECK(!document.contains("buffers"));
}

TEST_CASE("contours are written as loops without points on straight lines") {
  sim::ContourLines lines;
  lines.size = {5, 5};
  // The contours are a square of side 2 with a point in the middle of each side, and a triangle of another
  // level. Their points are interleaved.
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
  CHECK(end.target.z > 1.2F);  // Beyond its end, the path continues in a straight line.
  CHECK(end.target.x == doctest::Approx(3));
  CHECK(draw::standOn({{1, 2, 3}}, follow, 0.7).eye == glm::vec3(1, 4, 3));
}

namespace glb_materials_test {

using frame::test::GlbFile;
using frame::test::TemporaryFolder;

/// Returns a square of two triangles with different materials.
sim::MeshTable square() {
  sim::MeshTable mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

/// Returns an image of two pixels: red with full opacity, and blue with `opacity`.
std::shared_ptr<const scene::Image> picture(std::uint8_t opacity) {
  return std::make_shared<const scene::Image>(
      scene::Image{"leaf", {2, 1}, {255, 0, 0, 255, 0, 0, 255, opacity}});
}

scene::Material leaf() {
  scene::Material leaf;
  leaf.color = {1, 1, 1};
  leaf.roughness = 0.25F;
  leaf.metallic = 0.75F;
  leaf.finish.color = {{}, picture(0), scene::Wrap::clamp, scene::Wrap::mirror};
  leaf.finish.alpha = scene::Alpha::cut;
  leaf.finish.cutoff = 0.375F;
  leaf.finish.emission = {3, 1.5F, 0};
  leaf.finish.emissionStrength = 2;
  return leaf;
}

scene::Material film() {
  scene::Material film;
  film.color = {0.5F, 0.25F, 0.125F};
  film.roughness = 0.5F;
  film.finish.alpha = scene::Alpha::blend;
  film.finish.opacity = 0.5F;
  film.finish.doubleSided = true;
  return film;
}

struct Written {
  TemporaryFolder folder;
  std::filesystem::path file = folder / "it.glb";
  void write(const std::vector<std::byte>& bytes) const { writeFileAtomically(file, bytes); }
};

}  // namespace glb_materials_test

using namespace glb_materials_test;

TEST_CASE("glTF has a primitive and a material for each part, with pictures, cut-outs and emission") {
  const Written written;
  const scene::Material first = leaf(), second = film();
  sim::MeshLooks looks;
  looks.materials = {&first, &second};
  looks.partOf = {0, 1};
  written.write(frame::encodeGlb(std::array{frame::GlbObject{"square", square(), looks}}, {}));
  const GlbFile glb(written.file);
  const nlohmann::json& document = glb.document();
  const nlohmann::json& primitives = document["meshes"][0]["primitives"];
  REQUIRE(primitives.size() == 2);
  CHECK(glb.values<std::uint32_t>(primitives[0]["indices"]) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(glb.values<std::uint32_t>(primitives[1]["indices"]) == std::vector<std::uint32_t>{0, 2, 3});
  const nlohmann::json& cut = document["materials"][primitives[0]["material"].get<std::size_t>()];
  const nlohmann::json& pbr = cut["pbrMetallicRoughness"];
  CHECK(pbr["baseColorFactor"] == nlohmann::json({1, 1, 1, 1}));
  CHECK(pbr["metallicFactor"] == 0.75);
  CHECK(pbr["roughnessFactor"] == 0.25);
  CHECK(cut["alphaMode"] == "MASK");
  CHECK(cut["alphaCutoff"] == 0.375);
  CHECK(cut["emissiveFactor"] == nlohmann::json({1, 0.5, 0}));
  CHECK(cut["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] == 6);
  CHECK(document["extensionsUsed"] == nlohmann::json({"KHR_materials_emissive_strength"}));
  const nlohmann::json& texture = document["textures"][pbr["baseColorTexture"]["index"].get<std::size_t>()];
  const nlohmann::json& sampler = document["samplers"][texture["sampler"].get<std::size_t>()];
  CHECK(sampler["wrapS"] == 33071);
  CHECK(sampler["wrapT"] == 33648);
  CHECK(document["images"][texture["source"].get<std::size_t>()]["mimeType"] == "image/png");
  const nlohmann::json& blend = document["materials"][primitives[1]["material"].get<std::size_t>()];
  CHECK(blend["pbrMetallicRoughness"]["baseColorFactor"] == nlohmann::json({0.5, 0.25, 0.125, 0.5}));
  CHECK(blend["alphaMode"] == "BLEND");
  CHECK(!blend.contains("emissiveFactor"));
}

TEST_CASE("glTF materials are read back by the program as they were written") {
  const Written written;
  scene::Material first = leaf();
  const scene::Material second = film();
  first.finish.coat = 0.5F;
  first.finish.coatRoughness = 0.125F;
  first.finish.sheen = {0.25F, 0, 0};
  first.finish.transmission = 0.75F;
  first.finish.ior = 1.25F;
  sim::MeshLooks looks;
  looks.materials = {&first, &second};
  looks.partOf = {1, 0};
  looks.doubleSided = true;
  looks.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5F, 0.5F, 0.5F}};
  written.write(frame::encodeGlb(std::array{frame::GlbObject{"square", square(), looks}}, {}));
  const sim::Mesh mesh = sim::loadMesh(written.file);
  REQUIRE(mesh.materials.size() == 2);
  CHECK(mesh.ignored.empty());
  REQUIRE(mesh.indices.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const glm::vec3 place = mesh.positions[mesh.indices[i]];
    const glm::vec3 color = mesh.colors[mesh.indices[i]];
    CHECK(color == looks.colors[place == glm::vec3(0) ? 0 : place.y == 0 ? 1 : place.x == 1 ? 2 : 3]);
  }
  const sim::MeshMaterial& read = mesh.materials[0];
  CHECK(read.roughness == 0.25F);
  CHECK(read.metallic == 0.75F);
  CHECK(read.cutoff == 0.375F);
  CHECK(read.alpha == static_cast<int>(scene::Alpha::cut));
  CHECK(read.emission * read.emissionStrength == glm::vec3(6, 3, 0));
  CHECK(read.coat == 0.5F);
  CHECK(read.coatRoughness == 0.125F);
  CHECK(read.sheen == glm::vec3(0.25F, 0, 0));
  CHECK(read.transmission == 0.75F);
  CHECK(read.ior == 1.25F);
  CHECK(read.thin == false);
  CHECK(read.doubleSided);
  REQUIRE(mesh.images.size() == 1);
  const std::string& bytes = mesh.images[0].bytes;
  const frame::Image image = frame::decodeImage(std::as_bytes(std::span(bytes)), "leaf");
  CHECK(image.bytes == picture(0)->rgba);
  CHECK(mesh.materials[1].color == film().color);
  CHECK(mesh.materials[1].opacity == 0.5F);
}

TEST_CASE("glTF materials are read back by assimp") {
  const scene::Material first = leaf(), second = film();
  sim::MeshLooks looks;
  looks.materials = {&first, &second};
  looks.partOf = {0, 1};
  const std::vector<std::byte> file =
      frame::encodeGlb(std::array{frame::GlbObject{"square", square(), looks}}, {});
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFileFromMemory(file.data(), file.size(), aiProcess_ValidateDataStructure, "glb");
  REQUIRE_MESSAGE(scene != nullptr, importer.GetErrorString());
  REQUIRE(scene->mNumMeshes == 2);
  REQUIRE(scene->mNumTextures == 1);
  const aiMaterial& cut = *scene->mMaterials[scene->mMeshes[0]->mMaterialIndex];
  const aiMaterial& blend = *scene->mMaterials[scene->mMeshes[1]->mMaterialIndex];
  aiString name;
  CHECK(cut.GetTexture(aiTextureType_BASE_COLOR, 0, &name) == AI_SUCCESS);
  CHECK(scene->GetEmbeddedTexture(name.C_Str()) == scene->mTextures[0]);
  const aiTexture& embedded = *scene->mTextures[0];
  const frame::Image image = frame::decodeImage(
      std::as_bytes(std::span(reinterpret_cast<const char*>(embedded.pcData), embedded.mWidth)), "leaf");
  CHECK(image.bytes == picture(0)->rgba);
  float number = 0;
  CHECK(cut.Get(AI_MATKEY_METALLIC_FACTOR, number) == AI_SUCCESS);
  CHECK(number == 0.75F);
  CHECK(cut.Get(AI_MATKEY_ROUGHNESS_FACTOR, number) == AI_SUCCESS);
  CHECK(number == 0.25F);
  aiColor4D color;
  CHECK(blend.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS);
  CHECK(color == aiColor4D(0.5F, 0.25F, 0.125F, 0.5F));
}

TEST_CASE("glTF colours of a palette replace the material's colour, and other colours multiply it") {
  const scene::Material material = film();
  for (const bool own : {false, true}) {
    const Written written;
    sim::MeshLooks looks;
    looks.materials = {&material};
    looks.colors.assign(4, {0.5F, 1, 0});
    looks.ownColors = own;
    written.write(frame::encodeGlb(std::array{frame::GlbObject{"square", square(), looks}}, {}));
    const GlbFile glb(written.file);
    const nlohmann::json& primitive = glb.document()["meshes"][0]["primitives"][0];
    CHECK(glb.rows(primitive["attributes"]["COLOR_0"]) == looks.colors);
    const nlohmann::json& factor =
        glb.document()["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
    CHECK(factor == (own ? nlohmann::json({1, 1, 1, 0.5}) : nlohmann::json({0.5, 0.25, 0.125, 0.5})));
  }
}

TEST_CASE("glTF holds copies once, with a place, size and colour each") {
  const Written written;
  const scene::Material material = film();
  sim::ShownCopies copies;
  copies.shape = square();
  copies.material = &material;
  copies.places = {{1, 2, 3}, {4, 5, 6}};
  copies.turns = {glm::quat(1, 0, 0, 0), glm::quat(0, 0, 1, 0)};
  copies.scales = {0.5F, 2};
  copies.colors = {{1, 0, 0}, {0, 1, 0}};
  written.write(frame::encodeGlb(std::array{frame::GlbObject{"swarm", {}, {}, {copies}}}, {}));
  const GlbFile glb(written.file);
  const nlohmann::json& document = glb.document();
  REQUIRE(document["nodes"].size() == 1);
  CHECK(document["extensionsUsed"] == nlohmann::json({"EXT_mesh_gpu_instancing"}));
  const nlohmann::json& attributes =
      document["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
  CHECK(glb.rows(attributes["TRANSLATION"]) == copies.places);
  CHECK(glb.rows(attributes["SCALE"]) == std::vector<glm::vec3>{glm::vec3(0.5F), glm::vec3(2)});
  CHECK(glb.rows(attributes["_COLOR_0"]) == copies.colors);
  CHECK(document["accessors"][attributes["ROTATION"].get<std::size_t>()]["type"] == "VEC4");
  CHECK(document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] ==
        nlohmann::json({1, 1, 1, 0.5}));
  copies.glow = 4;
  written.write(frame::encodeGlb(std::array{frame::GlbObject{"swarm", {}, {}, {copies}}}, {}));
  const GlbFile glowing(written.file);
  CHECK(glowing.document()["materials"][0]["emissiveFactor"] == nlohmann::json({1, 1, 0}));
  CHECK(glowing.document()["materials"][0]["extensions"]["KHR_materials_emissive_strength"]
                          ["emissiveStrength"] == 2);
}
