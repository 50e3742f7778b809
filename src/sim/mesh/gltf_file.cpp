#include "sim/mesh/gltf_file.hpp"

#include "sim/mesh/builder.hpp"
#include "sim/mesh/gltf_document.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

/// Most primitives over all nodes.
constexpr std::size_t maxParts = 100'000;

/// Modes of a primitive by their numbers in glTF.
constexpr std::uint64_t triangleList = 4, triangleStrip = 5, triangleFan = 6;

/// A drawn mesh with the transform of its node.
struct Placed {
  std::size_t mesh;
  glm::mat4 transform;
};

struct Corner {
  std::array<float, 8> values;  ///< position, normal, texture coordinates
  bool operator==(const Corner&) const = default;
};
struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a over words
    for (const float value : corner.values)
      hash = (hash ^ std::bit_cast<std::uint32_t>(value == 0 ? 0.0F : value)) * 1099511628211U;
    return hash ^ hash >> 29U;
  }
};

class GltfReader {
 public:
  GltfReader(const std::filesystem::path& file, std::string_view text)
      : document_(file, text), builder_(file) {}

  Mesh read() {
    checkExtensions();
    const std::vector<Placed> placed = walk();
    std::size_t vertices = 0, corners = 0, parts = 0;
    for (const Placed& mesh : placed) {
      parts += primitivesOf(mesh.mesh).size();
      if (parts > maxParts) document_.refuse(fmt::format("has more than {} parts; join them", maxParts));
      forEachPrimitive(mesh.mesh, [&](const JsonValue& primitive) {
        vertices += document_.count(position(primitive));
        corners += cornerCount(primitive);
        if (vertices > maxMeshItems || corners > 3 * maxMeshItems)
          document_.refuse(
              fmt::format("has more than {} vertices or triangles; simplify it", maxMeshItems));
      });
    }
    for (const Placed& mesh : placed)
      forEachPrimitive(mesh.mesh, [&](const JsonValue& primitive) { add(primitive, mesh.transform); });
    return builder_.finish();
  }

 private:
  /// What has to be understood for the triangles to be right; looks and lights have not.
  void checkExtensions() const {
    const auto required = document_.root().find("extensionsRequired");
    if (!required) return;
    for (const std::string& name : required->texts()) {
      bool harmless = name == "KHR_mesh_quantization";
      for (const char* looks : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_"})
        harmless = harmless || name.starts_with(looks);
      if (!harmless)
        document_.refuse(fmt::format("needs the extension {}, which is not read; export it without", name));
    }
  }

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
    const JsonValue scene = document_.item("scenes", GltfDocument::number(document_.root(), "scene", 0));
    std::vector<Step> open;
    for (const std::uint64_t node : GltfDocument::wholeNumbers(scene, "nodes"))
      open.push_back({node, glm::mat4(1), 0});
    std::vector<Placed> placed;
    std::vector<bool> met(document_.size("nodes"));
    while (!open.empty()) {
      const Step step = open.back();
      open.pop_back();
      const JsonValue node = document_.item("nodes", step.node);
      if (met[step.node])
        document_.refuse(fmt::format("has a node with two parents (number {})", step.node));
      met[step.node] = true;
      if (step.depth > maxNodeDepth)
        document_.refuse(fmt::format("nests its nodes deeper than {} levels", maxNodeDepth));
      const glm::mat4 transform = step.parent * transformOf(node);
      if (node.has("mesh")) placed.push_back({GltfDocument::number(node, "mesh"), transform});
      for (const std::uint64_t child : GltfDocument::wholeNumbers(node, "children"))
        open.push_back({child, transform, step.depth + 1});
      if (open.size() > met.size()) document_.refuse("has a node with two parents");
    }
    return placed;
  }

  JsonValue primitivesOf(std::size_t mesh) const { return document_.item("meshes", mesh).at("primitives"); }

  template <class Visit>
  void forEachPrimitive(std::size_t mesh, const Visit& visit) const {
    primitivesOf(mesh).eachItem([&](const JsonValue& primitive) {
      if (!primitive.has("attributes")) document_.refuse("has a primitive without attributes");
      const std::uint64_t mode = modeOf(primitive);
      if (mode > triangleFan) document_.refuse(fmt::format("has a primitive of mode {}", mode));
      if (mode >= triangleList) visit(primitive);  // the others are points and lines
    });
  }

  static std::uint64_t modeOf(const JsonValue& primitive) {
    return GltfDocument::number(primitive, "mode", triangleList);
  }

  static std::size_t position(const JsonValue& primitive) {
    return GltfDocument::number(primitive.at("attributes"), "POSITION");
  }

  std::size_t cornerCount(const JsonValue& primitive) const {
    const std::size_t count = document_.count(
        primitive.has("indices") ? GltfDocument::number(primitive, "indices") : position(primitive));
    return modeOf(primitive) == triangleList ? count : 3 * count;
  }

  /// Values of an attribute for each vertex; empty where it has none.
  std::vector<float> attribute(const JsonValue& primitive, const char* name, std::size_t components,
                               std::size_t vertices) const {
    const JsonValue attributes = primitive.at("attributes");
    if (!attributes.has(name)) return {};
    const std::size_t accessor = GltfDocument::number(attributes, name);
    if (document_.count(accessor) != vertices)
      document_.refuse(
          fmt::format("has a {} for {} of {} vertices", name, document_.count(accessor), vertices));
    return document_.floats(accessor, components);
  }

  void add(const JsonValue& primitive, const glm::mat4& transform) {
    const std::size_t vertices = document_.count(position(primitive));
    const std::vector<float> positions = attribute(primitive, "POSITION", 3, vertices);
    const std::vector<float> normals = attribute(primitive, "NORMAL", 3, vertices);
    const std::vector<float> uvs = attribute(primitive, "TEXCOORD_0", 2, vertices);
    // Vertices that are equal in all that is read are one, so that computed normals are smooth.
    std::unordered_map<Corner, unsigned, CornerHash> known;
    std::vector<unsigned> first(vertices);
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < vertices; ++i) {
      Corner corner{};
      for (std::size_t k = 0; k < 3; ++k) {
        corner.values[k] = positions[3 * i + k];
        if (!normals.empty()) corner.values[3 + k] = normals[3 * i + k];
        if (k < 2 && !uvs.empty()) corner.values[6 + k] = uvs[2 * i + k];
      }
      const auto [at, fresh] = known.try_emplace(corner, static_cast<unsigned>(kept.size()));
      if (fresh) kept.push_back(corner);
      first[i] = at->second;
    }
    const std::vector<std::array<unsigned, 3>> triangles = trianglesOf(primitive, vertices);
    builder_.begin(kept.size(), triangles.size(), transform, !uvs.empty());
    for (const Corner& corner : kept) {
      const std::array<float, 8>& v = corner.values;
      builder_.vertex({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7]});
    }
    for (const auto& [a, b, c] : triangles) builder_.triangle({first[a], first[b], first[c]});
  }

  std::vector<std::array<unsigned, 3>> trianglesOf(const JsonValue& primitive, std::size_t vertices) const {
    std::vector<unsigned> corners;
    const bool indexed = primitive.has("indices");
    if (indexed) corners = document_.indices(GltfDocument::number(primitive, "indices"));
    for (const unsigned corner : corners)
      if (corner >= vertices)
        document_.refuse(fmt::format("has a triangle with vertex {} of {}", corner, vertices));
    if (!indexed)
      for (unsigned i = 0; i < vertices; ++i) corners.push_back(i);
    std::vector<std::array<unsigned, 3>> triangles;
    const std::uint64_t mode = modeOf(primitive);
    const std::size_t step = mode == triangleList ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      if (mode == triangleFan)  // a fan around the first
        triangles.push_back({corners[0], corners[i + 1], corners[i + 2]});
      else if (mode == triangleStrip && i % 2 == 1)  // every second of a strip is turned
        triangles.push_back({corners[i], corners[i + 2], corners[i + 1]});
      else
        triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
    }
    return triangles;
  }

  GltfDocument document_;
  MeshBuilder builder_;
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
