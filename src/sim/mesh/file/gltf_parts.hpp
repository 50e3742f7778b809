#pragma once
#include "sim/mesh/file/gltf_document.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/mat4x4.hpp>

namespace simreel::sim {

/// Vertex of a part of a glTF mesh.
struct GltfVertex {
  /// Position, normal, texture coordinates and colour (linear RGB). Missing colour components are 1, other
  /// missing components 0.
  std::array<float, 11> values{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1};
  std::array<std::uint32_t, 4> bones{};  ///< indices into the skin's list of joints
  std::array<float, 4> weights{};        ///< weights of the joints in `bones`; the sum is 1
  bool operator==(const GltfVertex&) const = default;
};

/// Triangles with one material. Vertices that are equal in all supported attributes are merged. If normals
/// are missing, MeshNormals::shown makes the triangles flat (glTF 2.0, 3.7.2.1).
struct GltfPart {
  bool hasUvs = false;
  bool hasColors = false;
  bool fades = false;  ///< true if a vertex colour has an opacity below 1, which is not supported
  int material = -1;   ///< material index, or -1 for none
  std::vector<GltfVertex> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
};

/// Handling of a skinned mesh. By default, the skin is ignored. If `kept` is set, joints and weights are
/// stored per vertex, for a body that animates them. If `pose` (one matrix per joint) is not empty, it
/// moves the vertices. `morphs` are the node's weights of morph targets; if empty, the mesh's own weights
/// are used.
struct GltfSkin {
  bool kept = false;
  std::vector<glm::mat4> pose;
  std::vector<float> morphs;
};

/// Returns a node's weights of morph targets; empty if the node has none.
[[nodiscard]] std::vector<float> morphsOf(const JsonValue& node);

class MeshBuilder;
/// Adds a vertex of a part to the builder.
void addVertex(MeshBuilder& builder, const GltfPart& part, const GltfVertex& vertex);

/// Reads the triangles of a glTF 2.0 or GLB file for any purpose. Throws the errors of GltfDocument.
class GltfParts {
 public:
  /// Rejects required extensions that affect the mesh.
  GltfParts(const std::filesystem::path& file, std::string_view text,
            MeshNormals normals = MeshNormals::shown);

  [[nodiscard]] const GltfDocument& document() const { return document_; }
  /// Adds one use of a mesh to the totals. Throws if the totals of vertices, triangles or parts exceed
  /// their limits, before any mesh is read.
  void count(std::size_t mesh);
  /// Calls `visit` with each part (GltfPart) of a mesh. Throws if `skin` requires joints and weights that
  /// are missing.
  template <class Visit>
  void eachPart(std::size_t mesh, const GltfSkin& skin, const Visit& visit) const {
    forEachPrimitive(mesh, [&](const JsonValue& primitive) { visit(part(mesh, primitive, skin)); });
  }
  /// Returns a description of each kind of counted primitive that is not drawn (lines or points), for
  /// example "lines (2)".
  [[nodiscard]] std::vector<std::string> undrawn() const;
  /// Returns the matrices of a skin's joints; `nodes` holds the nodes' world transforms.
  [[nodiscard]] std::vector<glm::mat4> poseOf(std::uint64_t skin,
                                              const std::vector<std::optional<glm::mat4>>& nodes) const;

 private:
  void checkExtensions() const;
  [[nodiscard]] JsonValue primitivesOf(std::size_t mesh) const;
  template <class Visit>
  void forEachPrimitive(std::size_t mesh, const Visit& visit) const;
  [[nodiscard]] std::size_t cornerCount(const JsonValue& primitive) const;
  [[nodiscard]] std::vector<float> attribute(const JsonValue& primitive, const char* name,
                                             std::size_t components, std::size_t vertices) const;
  [[nodiscard]] GltfPart part(std::size_t mesh, const JsonValue& primitive, const GltfSkin& skin) const;
  void checkCompression(const JsonValue& primitive) const;
  void morph(std::size_t mesh, const JsonValue& primitive, const std::vector<float>& weights,
             std::vector<GltfVertex>& vertices) const;
  void poseVertices(std::size_t mesh, const JsonValue& primitive, const std::vector<glm::mat4>& pose,
                    std::vector<GltfVertex>& vertices) const;
  void addBones(std::size_t mesh, const JsonValue& primitive, std::vector<GltfVertex>& vertices) const;
  [[nodiscard]] std::vector<std::array<unsigned, 3>> trianglesOf(const JsonValue& primitive,
                                                                 std::size_t vertices) const;

  GltfDocument document_;
  MeshNormals normals_;
  std::size_t vertices_ = 0, corners_ = 0, parts_ = 0;  ///< totals over the meshes counted so far
  std::size_t points_ = 0, lines_ = 0;                  ///< number of point primitives and of line
                                                        ///< primitives
};

/// Modes of a primitive as numbered by glTF.
constexpr std::uint64_t triangleList = 4, triangleStrip = 5, triangleFan = 6;

template <class Visit>
void GltfParts::forEachPrimitive(std::size_t mesh, const Visit& visit) const {
  primitivesOf(mesh).eachItem([&](const JsonValue& primitive) {
    if (!primitive.has("attributes")) document_.refuse("has a primitive without attributes");
    const std::uint64_t mode = GltfDocument::number(primitive, "mode", triangleList);
    if (mode > triangleFan) document_.refuse(fmt::format("has a primitive of mode {}", mode));
    if (mode >= triangleList) visit(primitive);  // modes below triangleList are points and lines
  });
}

}  // namespace simreel::sim
