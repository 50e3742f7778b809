// Tests files that hold a surface at several frames. glTF must follow its specification, and sequences that
// cannot be stored must be refused.
#include "frame/mesh/mesh_sequence.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/mesh/glb.hpp"
#include "frame/mesh/obj.hpp"
#include "frame/mesh/ply.hpp"
#include "glb_file.hpp"
#include "help.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

using frame::test::GlbFile;
using frame::test::TemporaryFolder;

/// Two moved triangles with a common edge. The first vertex is unused.
sim::MeshTable movedPair(float by) {
  sim::MeshTable mesh;
  mesh.positions = {{9, 9, 9}, {0, by, 0}, {1, 0, 0}, {1, 0, 1 + 2 * by}, {0, 0, 1}};
  mesh.normals = {{1, 0, 0}, {0, 1, 0}, {0, 1, 0}, {by, 1 - by, 0}, {0, 1, 0}};
  mesh.uvs = {{0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.indices = {1, 3, 2, 1, 4, 3};
  return mesh;
}

std::string failureOf(const std::string& format, const std::vector<int>& frames,
                      const std::vector<sim::MeshTable>& meshes) {
  const TemporaryFolder folder;
  const auto file = folder / "it";
  std::string message = "no failure";
  try {
    const auto sequence = frame::openSequence(format, file, {"it", frames, 30, {}});
    for (const sim::MeshTable& mesh : meshes) sequence->add(mesh);
    sequence->finish();
  } catch (const UserError& error) {
    message = error.what();
    CHECK(!pathExists(file));
    CHECK(!pathExists(file.string() + ".part"));
  }
  return message;
}

}  // namespace

TEST_CASE("PLY and glTF meshes are read back bit for bit, OBJ within the library's decimal precision") {
  const TemporaryFolder folder;
  sim::MeshTable mesh;
  std::uint32_t word = 1;
  const auto any = [&word] {  // Returns numbers with magnitudes between 1e-6 and 1e6 and with random
                              // mantissa bits.
    word = word * 747796405U + 2891336453U;
    const float mantissa = 1.0F + static_cast<float>(word >> 9U) * 0x1p-23F;
    return std::ldexp((word & 1U) == 0 ? mantissa : -mantissa, static_cast<int>(word % 40) - 20);
  };
  for (unsigned i = 0; i < 300; ++i) {
    mesh.positions.emplace_back(any(), any(), any());
    mesh.normals.emplace_back(i % 3 == 0, i % 3 == 1, i % 3 == 2);
    mesh.indices.push_back(i);
  }
  const auto written = [&](const char* name, const auto& bytes) {
    writeFileAtomically(folder / name, bytes);
    return folder / name;
  };
  std::vector<float> values;
  for (std::size_t i = 0; i < 300; ++i)
    for (const glm::vec3& row : {mesh.positions[i], mesh.normals[i]})
      values.insert(values.end(), {row.x, row.y, row.z});
  const std::vector<const char*> columns = {"x", "y", "z", "nx", "ny", "nz"};
  for (const auto& file : {written("a.obj", frame::encodeObj(mesh, {})),
                           written("a.glb", frame::encodeGlb(std::array{frame::GlbObject{"a", mesh}}, {})),
                           written("a.ply", frame::encodePly(columns, values, mesh.indices, {}))}) {
    CAPTURE(file.string());
    const bool isText = file.extension() == ".obj";
    const sim::Mesh read = sim::loadMesh(file);
    REQUIRE(read.indices.size() == mesh.indices.size());
    for (std::size_t i = 0; i < 300; ++i) {
      const glm::vec3 found = read.positions[read.indices[i]], wanted = mesh.positions[i];
      for (int k = 0; k < 3; ++k)
        CHECK(std::abs(found[k] - wanted[k]) <= (isText ? 0x1p-23F * std::abs(wanted[k]) : 0.0F));
      CHECK(read.normals[read.indices[i]] == mesh.normals[i]);
    }
  }
}

TEST_CASE("mesh sequences: glTF animates by morph targets and weights") {
  const TemporaryFolder folder;
  const auto file = folder / "pair.glb";
  const auto sequence = frame::openSequence("glb", file, {"pair", {4, 5, 8}, 10, {"a comment"}});
  for (const float by : {0.0F, 0.5F, 1.0F}) sequence->add(movedPair(by));
  CHECK(!pathExists(file));
  sequence->finish();
  const GlbFile glb(file);
  const nlohmann::json& document = glb.document();
  REQUIRE(document["meshes"].size() == 1);
  const nlohmann::json& mesh = document["meshes"][0];
  REQUIRE(mesh["primitives"].size() == 1);
  const nlohmann::json& primitive = mesh["primitives"][0];
  CHECK(primitive.value("mode", 4) == 4);  // by glTF 5.24, mode 4 is triangles
  CHECK(glb.values<std::uint32_t>(primitive["indices"]) == std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2});
  REQUIRE(primitive["targets"].size() == 2);
  CHECK(mesh["extras"]["targetNames"] == nlohmann::json({"frame 5", "frame 8"}));
  CHECK(!mesh.contains("weights"));  // by glTF 3.7.2.2, weights default to 0
  // By glTF 3.11, one channel animates the weights of the node with the mesh. The sampler's times are in
  // seconds.
  REQUIRE(document["animations"].size() == 1);
  const nlohmann::json& animation = document["animations"][0];
  REQUIRE(animation["channels"].size() == 1);
  const nlohmann::json& target = animation["channels"][0]["target"];
  CHECK(target["path"] == "weights");
  CHECK(document["nodes"].at(target["node"].get<std::size_t>())["mesh"] == 0);
  const nlohmann::json& sampler =
      animation["samplers"].at(animation["channels"][0]["sampler"].get<std::size_t>());
  CHECK(sampler.value("interpolation", "LINEAR") == "LINEAR");
  CHECK(glb.values<float>(sampler["input"]) == std::vector<float>{0, 0.1F, 0.4F});
  const std::vector<float> weights = glb.values<float>(sampler["output"]);
  REQUIRE(weights.size() == 6);
  // By glTF 3.7.2.2, the result is the mesh's attribute plus the weighted sum of the targets.
  for (std::size_t key = 0; key < 3; ++key) {
    const sim::MeshTable wanted = movedPair(0.5F * static_cast<float>(key));
    for (const auto& [name, table] :
         {std::pair{"POSITION", &wanted.positions}, std::pair{"NORMAL", &wanted.normals}}) {
      std::vector<glm::vec3> found = glb.rows(primitive["attributes"][name]);
      REQUIRE(found.size() == 4);  // The unused vertex is not written.
      for (std::size_t k = 0; k < 2; ++k) {
        const std::vector<glm::vec3> moved = glb.rows(primitive["targets"][k][name]);
        REQUIRE(moved.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) found[i] += weights[2 * key + k] * moved[i];
      }
      for (std::size_t i = 0; i < 4; ++i) CHECK(found[i] == (*table)[i + 1]);
    }
  }
}

TEST_CASE("mesh sequences: one file holds one surface") {
  sim::MeshTable turned = movedPair(0.1F), longer = movedPair(0.1F), wider = movedPair(0.1F),
                 drawn = turned;
  std::swap(turned.indices[1], turned.indices[2]);
  longer.indices.insert(longer.indices.end(), {1, 2, 4});
  wider.positions.emplace_back(0);
  wider.normals.emplace_back(0);
  wider.uvs.emplace_back(0);
  drawn.uvs[2].x = 0.5F;
  for (const char* format : frame::sequenceFormats) {
    const auto second = [&](const sim::MeshTable& mesh) {
      return failureOf(format, {7, 9}, {movedPair(0), mesh});
    };
    CHECK(second(movedPair(1)) == "no failure");
    CHECK(second(turned).find("\"it\" has other triangles in frame 9") == 0);
    CHECK(second(longer).find("\"it\" has 3 triangles instead of 2 in frame 9") == 0);
    CHECK(second(wider).find("\"it\" has 6 vertices instead of 5 in frame 9") == 0);
    CHECK(second(drawn).find("\"it\" has other texture coordinates in frame 9") == 0);
    CHECK(failureOf(format, {7}, {{}}).find("\"it\" has no triangles in frame 7") == 0);
  }
  CHECK(failureOf("pc2", {0, 2, 3}, {}).find("--frames: PC2 has one step") == 0);
}

TEST_CASE("mesh sequences: a sequence above the size limit of GLB is refused at the first frame") {
  std::vector<int> frames(60'000);
  for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = static_cast<int>(i);
  const std::string said = failureOf("glb", frames, {movedPair(0)});
  CHECK(said.find("\"it\": 60000 frames of 4 vertices are 14.") == 0);
}

TEST_CASE("files in parts: a complete file replaces the old one, and an unfinished one is removed") {
  const TemporaryFolder folder;
  const auto file = folder / "file";
  const auto bytes = [](std::string_view text) { return std::as_bytes(std::span(text)); };
  {
    PartFile part(file);
    part.append(bytes("one "));
    CHECK(pathExists(file.string() + ".part"));
  }
  CHECK(!pathExists(file.string() + ".part"));
  PartFile part(file);
  part.append(bytes("one two"));
  part.put(0, bytes("TWO"));
  part.append(bytes(" three"));
  CHECK(!pathExists(file));
  part.finish();
  CHECK(readFile(file, "file") == "TWO two three");
  CHECK(!pathExists(file.string() + ".part"));
}
