#include "sim/mesh/file/gltf_file.hpp"

#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/gltf_materials.hpp"
#include "sim/mesh/file/gltf_parts.hpp"
#include "sim/mesh/file/texture_place.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

/// Mesh instance with the transform of its node and, optionally, its skin.
struct Placed {
  std::size_t mesh;
  glm::mat4 transform;
  std::optional<std::uint64_t> skin;
  std::vector<float> morphs;
};

class GltfReader {
 public:
  GltfReader(const std::filesystem::path& file, std::string_view text, MeshNormals normals)
      : parts_(file, text, normals), builder_(file) {}

  Mesh read() {
    const std::vector<Placed> placed = walk();
    for (const Placed& mesh : placed) parts_.count(mesh.mesh);
    int flat = 0;
    for (const Placed& mesh : placed) {
      GltfSkin skin;
      skin.morphs = mesh.morphs;
      if (mesh.skin) skin.pose = parts_.poseOf(*mesh.skin, nodes_);
      // The joints alone determine the vertices' positions; the node's transform has no effect (glTF 2.0,
      // 3.7.3.2).
      const glm::mat4 transform = mesh.skin ? glm::mat4(1) : mesh.transform;
      flat += glm::determinant(glm::mat3(transform)) == 0 ? 1 : 0;
      parts_.eachPart(mesh.mesh, skin, [&](const GltfPart& part) { add(part, transform); });
    }
    Mesh mesh = builder_.finish();
    mesh.undrawn = parts_.undrawn();
    if (flat > 0) mesh.undrawn.push_back(fmt::format("what a scale of 0 makes flat (nodes: {})", flat));
    GltfMaterials looks = readMaterials(parts_.document());
    mesh.materials = std::move(looks.materials);
    mesh.images = std::move(looks.images);
    mesh.ignored = std::move(looks.ignored);
    if (fades_) mesh.ignored.emplace_back("the opacity in COLOR_0");
    if (parts_.document().size("animations") > 0)
      mesh.ignored.emplace_back("animations (a \"body\" shows those of nodes)");
    if (mesh.materials.empty()) mesh.materialOf.clear();
    placeTextures(mesh);
    return mesh;
  }

 private:
  static glm::mat4 transformOf(const JsonValue& node) {
    const std::vector<float> matrix = GltfDocument::numbers(node, "matrix", 16);
    if (!matrix.empty()) return glm::make_mat4(matrix.data());
    const auto or3 = [&](const char* key, float otherwise) {
      const std::vector<float> v = GltfDocument::numbers(node, key, 3);
      return v.empty() ? glm::vec3(otherwise) : glm::vec3(v[0], v[1], v[2]);
    };
    const glm::vec3 place = or3("translation", 0), scale = or3("scale", 1);
    const std::array<double, 4> q = GltfDocument::rotation(node);
    const auto x = static_cast<float>(q[0]), y = static_cast<float>(q[1]), z = static_cast<float>(q[2]),
               w = static_cast<float>(q[3]);
    // These are the columns of the unit quaternion's rotation matrix, each multiplied by a scale.
    return {glm::vec4(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0) * scale.x,
            glm::vec4(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0) * scale.y,
            glm::vec4(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0) * scale.z,
            glm::vec4(place, 1)};
  }

  /// Collects the mesh instances of the default scene's nodes, which must form trees. If the file has no
  /// nodes, collects all meshes.
  std::vector<Placed> walk() {
    struct Step {
      std::uint64_t node;
      glm::mat4 parent;
      int depth;
    };
    std::vector<Step> open;
    for (const std::uint64_t node : parts_.document().rootNodes()) open.push_back({node, glm::mat4(1), 0});
    std::vector<Placed> placed;
    nodes_.resize(parts_.document().size("nodes"));
    if (nodes_.empty())
      for (std::size_t i = 0; i < parts_.document().size("meshes"); ++i)
        placed.push_back({i, glm::mat4(1), std::nullopt, {}});
    while (!open.empty()) {
      const Step step = open.back();
      open.pop_back();
      const JsonValue node = parts_.document().item("nodes", step.node);
      if (nodes_[step.node])
        parts_.document().refuse(fmt::format("has a node with two parents (number {})", step.node));
      if (step.depth > maxNodeDepth)
        parts_.document().refuse(fmt::format("nests its nodes deeper than {} levels", maxNodeDepth));
      const glm::mat4 transform = step.parent * transformOf(node);
      nodes_[step.node] = transform;
      if (node.has("mesh")) {
        placed.push_back({GltfDocument::number(node, "mesh"), transform, std::nullopt, morphsOf(node)});
        if (node.has("skin")) placed.back().skin = GltfDocument::number(node, "skin");
      }
      for (const std::uint64_t child : GltfDocument::wholeNumbers(node, "children"))
        open.push_back({child, transform, step.depth + 1});
      if (open.size() > nodes_.size()) parts_.document().refuse("has a node with two parents");
    }
    return placed;
  }

  void add(const GltfPart& part, const glm::mat4& transform) {
    builder_.begin(part.vertices.size(), part.triangles.size(), transform, part.hasUvs, part.material);
    for (const GltfVertex& vertex : part.vertices) addVertex(builder_, part, vertex);
    fades_ = fades_ || part.fades;
    for (const auto& triangle : part.triangles) builder_.triangle(triangle);
  }

  GltfParts parts_;
  MeshBuilder builder_;
  std::vector<std::optional<glm::mat4>> nodes_;  ///< world transforms of the nodes that are drawn
  bool fades_ = false;
};

}  // namespace

Mesh readGltf(const std::filesystem::path& file, std::string_view text, MeshNormals normals) {
  try {
    return GltfReader(file, text, normals).read();
  } catch (const JsonError& error) {
    refuseMesh(file, fmt::format("is not valid glTF: {}", error.what()));
  }
}

}  // namespace simreel::sim
