#include "sim/mesh/gltf_file.hpp"

#include "sim/mesh/builder.hpp"
#include "sim/mesh/gltf_materials.hpp"
#include "sim/mesh/gltf_parts.hpp"
#include "sim/mesh/texture_place.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

/// A drawn mesh with the transform of its node.
struct Placed {
  std::size_t mesh;
  glm::mat4 transform;
};

class GltfReader {
 public:
  GltfReader(const std::filesystem::path& file, std::string_view text)
      : parts_(file, text), builder_(file) {}

  Mesh read() {
    const std::vector<Placed> placed = walk();
    for (const Placed& mesh : placed) parts_.count(mesh.mesh);
    for (const Placed& mesh : placed)
      parts_.eachPart(mesh.mesh, false, [&](const GltfPart& part) { add(part, mesh.transform); });
    Mesh mesh = builder_.finish();
    GltfMaterials looks = readMaterials(parts_.document());
    mesh.materials = std::move(looks.materials);
    mesh.images = std::move(looks.images);
    mesh.ignored = std::move(looks.ignored);
    if (fades_) mesh.ignored.emplace_back("the opacity in COLOR_0");
    if (parts_.document().size("animations") > 0)
      mesh.ignored.emplace_back("animations (a \"body\" has those of its bones)");
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
    const std::vector<float> q = GltfDocument::numbers(node, "rotation", 4);
    const float x = q.empty() ? 0 : q[0], y = q.empty() ? 0 : q[1], z = q.empty() ? 0 : q[2],
                w = q.empty() ? 1 : q[3];
    // The matrix of a unit quaternion, column by column, each scaled.
    return {glm::vec4(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 0) * scale.x,
            glm::vec4(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 0) * scale.y,
            glm::vec4(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y), 0) * scale.z,
            glm::vec4(place, 1)};
  }

  /// The meshes of the default scene's nodes, which have to form trees.
  std::vector<Placed> walk() const {
    struct Step {
      std::uint64_t node;
      glm::mat4 parent;
      int depth;
    };
    const JsonValue scene =
        parts_.document().item("scenes", GltfDocument::number(parts_.document().root(), "scene", 0));
    std::vector<Step> open;
    for (const std::uint64_t node : GltfDocument::wholeNumbers(scene, "nodes"))
      open.push_back({node, glm::mat4(1), 0});
    std::vector<Placed> placed;
    std::vector<bool> met(parts_.document().size("nodes"));
    while (!open.empty()) {
      const Step step = open.back();
      open.pop_back();
      const JsonValue node = parts_.document().item("nodes", step.node);
      if (met[step.node])
        parts_.document().refuse(fmt::format("has a node with two parents (number {})", step.node));
      met[step.node] = true;
      if (step.depth > maxNodeDepth)
        parts_.document().refuse(fmt::format("nests its nodes deeper than {} levels", maxNodeDepth));
      const glm::mat4 transform = step.parent * transformOf(node);
      if (node.has("mesh")) placed.push_back({GltfDocument::number(node, "mesh"), transform});
      for (const std::uint64_t child : GltfDocument::wholeNumbers(node, "children"))
        open.push_back({child, transform, step.depth + 1});
      if (open.size() > met.size()) parts_.document().refuse("has a node with two parents");
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
  bool fades_ = false;
};

}  // namespace

Mesh readGltf(const std::filesystem::path& file, std::string_view text) {
  try {
    return GltfReader(file, text).read();
  } catch (const JsonError& error) {
    refuseMesh(file, fmt::format("is no sound glTF: {}", error.what()));
  }
}

}  // namespace simreel::sim
