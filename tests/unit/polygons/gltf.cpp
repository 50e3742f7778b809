// Tests requirements of glTF 2.0 for meshes: flat normals for files without normals, skins in their pose,
// and files without scenes.
#include "base/error.hpp"
#include "sim/body/figure.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"
#include "unit/polygons/float_gltf.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace simreel::test::polygons_gltf {

namespace {

using Json = nlohmann::json;
using Document = FloatGltf;

/// Positions of a roof as a triangle strip, which consists of two triangles that share an edge.
const std::vector<float> roof = {1, 0, 0, 0, 0, 1, 0, 1, 1, -1, 1, 0};
const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
const std::vector<float> up = {0, 0, 1, 0, 0, 1, 0, 0, 1};

/// Returns a skinned triangle whose only joint is at a height of 7 m. The node with the mesh is 100 m away.
Document skinned() {
  Document d;
  Json attributes = {{"POSITION", d.add(triangle, "VEC3", 3)}, {"NORMAL", d.add(up, "VEC3", 3)}};
  attributes["JOINTS_0"] = d.add(std::vector<float>(12, 0), "VEC4", 4);
  attributes["WEIGHTS_0"] = d.add({1, 0, 0, 0, 1, 0, 0, 0, 0.25F, 0, 0.25F, 0}, "VEC4", 4);
  // The inverse bind matrix is a quarter turn about x, which the node reverses.
  const int bind = d.add({1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1}, "MAT4", 16);
  d.json["meshes"] = {{{"primitives", {{{"attributes", attributes}}}}}};
  d.json["scenes"][0]["nodes"] = {0, 1};
  d.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}},
                     {{"translation", {0, 7, 0}}}};
  d.json["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", bind}}};
  return d;
}

}  // namespace

TEST_CASE("glTF without normals is flat shaded; given normals are kept") {
  for (const bool strip : {true, false}) {
    Document d;
    Json primitive = {{"attributes", {{"POSITION", d.add(roof, "VEC3", 3)}}}};
    if (strip)
      primitive["mode"] = 5;
    else
      primitive["attributes"]["POSITION"] =
          d.add({1, 0, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1, -1, 1, 0, 0, 1, 1}, "VEC3", 3);
    d.json["meshes"] = {{{"primitives", {primitive}}}};
    const sim::Mesh mesh = d.mesh();
    CHECK(mesh.positions.size() == 6);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[i / 3 * 3 + k]]; };
      const glm::vec3 face = glm::normalize(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
      CHECK(glm::length(mesh.normals[mesh.indices[i]] - face) < 1e-6F);
    }
  }
  Document d;
  const Json attributes = {{"POSITION", d.add(triangle, "VEC3", 3)},
                           {"NORMAL", d.add({0, 0, 1, 0, 1, 0, 1, 0, 0}, "VEC3", 3)}};
  d.json["meshes"] = {{{"primitives", {{{"attributes", attributes}}}}}};
  CHECK(d.mesh().normals == std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}});
}

TEST_CASE("a skinned glTF mesh is posed by its joints, independent of its node's transform") {
  Document d = skinned();
  const sim::Mesh mesh = d.mesh();
  CHECK(mesh.positions == std::vector<glm::vec3>{{0, 7, 0}, {1, 7, 0}, {0, 7, 1}});
  for (const glm::vec3& n : mesh.normals) CHECK(n == glm::vec3(0, -1, 0));
  d.json["skins"][0].erase("inverseBindMatrices");
  CHECK(d.mesh().positions[2] == glm::vec3(0, 8, 0));
  // A second set of weights must also be used. The joint and its child, which is 2 m higher, have equal
  // weights.
  d.json["nodes"][1]["children"] = {2};
  d.json["nodes"].push_back({{"translation", {0, 2, 0}}});
  d.json["skins"][0]["joints"] = {1, 2};
  Json& attributes = d.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_1"] = d.add(std::vector<float>(12, 1), "VEC4", 4);
  attributes["WEIGHTS_1"] = d.add({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0, 0, 0}, "VEC4", 4);
  CHECK(d.mesh().positions == std::vector<glm::vec3>{{0, 8, 0}, {1, 8, 0}, {0, 9, 0}});
}

TEST_CASE("a broken skin is refused") {
  Document d = skinned();
  d.json["skins"][0]["joints"] = {5};
  checkHas(d.refusal(), "joint 0 is node 5, which is not in its default scene");
  d = skinned();
  d.json["scenes"][0]["nodes"] = {0};
  checkHas(d.refusal(), "joint 0 is node 1, which is not in");
  d = skinned();
  d.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  checkHas(d.refusal(), "lacks JOINTS_0 or WEIGHTS_0");
  d = skinned();
  d.json["nodes"][0]["skin"] = 3;
  checkHas(d.refusal(), "names number 3 of its 1 skins");
}

TEST_CASE("glTF without scenes uses its root nodes, and without nodes its meshes") {
  Document d;
  d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}}}}}};
  d.json["nodes"] = {{{"mesh", 0}}, {{"children", {0}}, {"translation", {0, 0, 5}}}};
  d.json.erase("scenes");
  d.json.erase("scene");
  CHECK(d.mesh().positions[1] == glm::vec3(1, 0, 5));
  d.json.erase("nodes");
  CHECK(d.mesh().positions[1] == glm::vec3(1, 0, 0));
}

TEST_CASE(
    "glTF: data compressed by extensions is read from its fallback, or refused by the extension's name") {
  Document d;
  const Json draco = {
      {"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}};
  d.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}, {"extensions", draco}}}}}};
  d.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  CHECK(d.mesh().positions.size() == 3);
  d.json["accessors"][0].erase("bufferView");
  checkHas(d.refusal(), "only in KHR_draco_mesh_compression");
  Document packed;
  packed.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", packed.add(triangle, "VEC3", 3)}}}}}}}};
  packed.json["bufferViews"][0]["buffer"] = 1;
  checkHas(packed.refusal(), "names number 1 of its 1 buffers");
  packed.fallback = {{"byteLength", 36},
                     {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}};
  checkHas(packed.refusal(), "only in EXT_meshopt_compression");
  // Without the extension, missing values are zeros.
  d.json["meshes"][0]["primitives"][0].erase("extensions");
  CHECK(d.mesh().positions == std::vector<glm::vec3>{glm::vec3(0)});
}

TEST_CASE("glTF: lines, points and unsupported image formats are reported as not drawn") {
  Document d;
  const Json attributes = {{"POSITION", d.add(triangle, "VEC3", 3)}};
  d.json["meshes"] = {{{"primitives",
                        {{{"attributes", attributes}, {"material", 0}},
                         {{"attributes", attributes}, {"mode", 0}},
                         {{"attributes", attributes}, {"mode", 3}}}}}};
  d.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  d.json["textures"] = {{{"source", 0}}};
  d.json["images"] = {{{"uri", "data:image/webp;base64,UklGRjwAAABXRUJQVlA4IA=="}}};
  const sim::Mesh mesh = d.mesh();
  CHECK(mesh.undrawn == std::vector<std::string>{"lines (1)", "points (1)"});
  CHECK(mesh.ignored == std::vector<std::string>{"image 0 (a picture of the format WebP)"});
  CHECK(mesh.materials.at(0).colorMap.image == -1);
}

TEST_CASE("glTF: quaternions of any length are normalized") {
  Document d;
  d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}}}}}};
  d.json["nodes"][0]["rotation"] = {0, 0, 3, 3};  // This quaternion for a quarter turn about z is not
                                                  // normalized.
  const sim::Mesh turned = d.mesh();
  CHECK(glm::length(turned.positions[1] - glm::vec3(0, 1, 0)) < 1e-6F);
  CHECK(glm::length(turned.positions[2] - glm::vec3(-1, 0, 0)) < 1e-6F);
  d.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
  checkHas(d.refusal(), "rotation must be a quaternion of length 1");
}

TEST_CASE("glTF: zero scales, and required but unsupported versions, are reported") {
  Document d;
  d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}}}}}};
  CHECK(d.mesh().undrawn.empty());
  d.json["nodes"][0]["scale"] = {1, 0, 1};
  CHECK(d.mesh().undrawn == std::vector<std::string>{"what a scale of 0 makes flat (nodes: 1)"});
  d.json["nodes"][0].erase("scale");
  d.json["asset"]["minVersion"] = "2.0";
  CHECK(d.mesh().undrawn.empty());
  d.json["asset"]["minVersion"] = "2.1";
  checkHas(d.refusal(), "requires glTF 2.1, but only glTF 2.0 is supported");
}

TEST_CASE("GLB: a header length that differs from the file size is refused or reported") {
  Document d;
  d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}}}}}};
  const std::string json = d.text();
  const auto glb = [&](std::size_t named, std::uint32_t version, const std::string& more) {
    const auto word = [](std::size_t value) {
      std::string bytes;
      for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255U);
      return bytes;
    };
    const TemporaryFile file(
        "polygons.glb", "glTF" + word(version) + word(named) + word(json.size()) + "JSON" + json + more);
    return sim::importMesh(file.path());
  };
  const auto refusal = [&](std::size_t named, std::uint32_t version) {
    try {
      static_cast<void>(glb(named, version, ""));
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string("nothing was refused");
  };
  const std::size_t whole = json.size() + 20;
  CHECK(glb(whole, 2, "").undrawn.empty());
  CHECK(glb(whole, 2, "xyz").undrawn ==
        std::vector<std::string>{"bytes behind the end that its header names (3)"});
  checkHas(refusal(whole + 4, 2),
           fmt::format("its header announces {} bytes, but it has {}", whole + 4, whole));
  checkHas(refusal(whole - 4, 2), "is cut off");
  checkHas(refusal(whole, 1), "is a binary glTF of version 1");
}

TEST_CASE("glTF morph targets have the weights of their node, or else of their mesh") {
  for (const bool ofNode : {false, true}) {
    Document d;
    const int place = d.add(triangle, "VEC3", 3), normal = d.add(up, "VEC3", 3);
    const int lift = d.add({0, 0, 4, 0, 0, 0, 0, 0, 0}, "VEC3", 3);
    const int shift = d.add({8, 0, 0, 8, 0, 0, 8, 0, 0}, "VEC3", 3);
    const int lean = d.add({0, 1, -1, 0, 1, -1, 0, 1, -1}, "VEC3", 3);
    d.json["meshes"] = {
        {{"weights", {0.25, 0}},
         {"primitives",
          {{{"attributes", {{"POSITION", place}, {"NORMAL", normal}}},
            {"targets", {{{"POSITION", lift}, {"NORMAL", lean}}, {{"POSITION", shift}}}}}}}}};
    if (ofNode) d.json["nodes"][0]["weights"] = {1, 0.5};
    const sim::Mesh mesh = d.mesh();
    CHECK(mesh.ignored.empty());
    CHECK(mesh.positions[0] == (ofNode ? glm::vec3(4, 0, 4) : glm::vec3(0, 0, 1)));
    CHECK(mesh.positions[1] == (ofNode ? glm::vec3(5, 0, 0) : glm::vec3(1, 0, 0)));
    // The normal is (0, 0, 1) + weight * (0, 1, -1), normalized.
    CHECK(mesh.normals[0].y == doctest::Approx(ofNode ? 1.0 : 0.25 / std::hypot(0.25, 0.75)));
  }
}

TEST_CASE("glTF morph targets of another size are refused") {
  Document d;
  const int place = d.add(triangle, "VEC3", 3), one = d.add({1, 0, 0}, "VEC3", 3);
  d.json["meshes"] = {
      {{"weights", {1}},
       {"primitives", {{{"attributes", {{"POSITION", place}}}, {"targets", {{{"POSITION", one}}}}}}}}};
  checkHas(d.refusal(), "has a morph target with a POSITION for 1 of 3 vertices");
  d.json["nodes"][0]["weights"] = {1, 1};
  checkHas(d.refusal(), "has 2 weights for the 1 morph targets of its mesh 0");
}

TEST_CASE("glTF samplers wrap along each axis on its own") {
  Document d;
  d.json["meshes"] = {
      {{"primitives", {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}, {"material", 0}}}}}};
  d.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  d.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
  d.json["images"] = {{{"uri", "data:image/png;base64,"}}};
  const auto wraps = [&](const Json& sampler) {
    d.json["samplers"] = Json::array({sampler});
    const sim::Mesh mesh = d.mesh();
    CHECK(mesh.ignored.empty());
    return std::pair(mesh.materials.at(0).colorMap.wrapU, mesh.materials.at(0).colorMap.wrapV);
  };
  CHECK(wraps(Json::object()) == std::pair(scene::Wrap::repeat, scene::Wrap::repeat));
  CHECK(wraps({{"wrapS", 33071}, {"wrapT", 33648}}) == std::pair(scene::Wrap::clamp, scene::Wrap::mirror));
  CHECK(wraps({{"wrapS", 10497}, {"wrapT", 33071}}) == std::pair(scene::Wrap::repeat, scene::Wrap::clamp));
}

}  // namespace simreel::test::polygons_gltf
