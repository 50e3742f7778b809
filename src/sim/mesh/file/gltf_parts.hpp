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

/// A vertex of a part of a glTF mesh.
struct GltfVertex {
  /// Position, normal, texture coordinates, colour (linear RGB); 0 where there are none, but for colours 1.
  std::array<float, 11> values{0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1};
  std::array<std::uint32_t, 4> bones{};  ///< numbers in the skin's list of joints
  std::array<float, 4> weights{};        ///< of those; sum 1
  bool operator==(const GltfVertex&) const = default;
};

/// Triangles with one material. Vertices that are equal in all that is read are one. Without normals the
/// triangles are flat (glTF 2.0, 3.7.2.1) where they are shown.
struct GltfPart {
  bool hasUvs = false;
  bool hasColors = false;
  bool fades = false;  ///< whether a colour has an opacity below 1, which is not read
  int material = -1;   ///< its number; -1: none
  std::vector<GltfVertex> vertices;
  std::vector<std::array<unsigned, 3>> triangles;
};

/// What a node makes of its mesh's bones: nothing; they stay, for who moves them; or they have moved it,
/// by a matrix for each joint.
struct GltfSkin {
  bool kept = false;
  std::vector<glm::mat4> pose;
};

class MeshBuilder;
/// The part's vertex as the file has it is the builder's next one.
void addVertex(MeshBuilder& builder, const GltfPart& part, const GltfVertex& vertex);

/// The triangles of a glTF 2.0 or GLB file, whatever becomes of them. Throws as GltfDocument does.
class GltfParts {
 public:
  /// Refuses required extensions that change the mesh.
  GltfParts(const std::filesystem::path& file, std::string_view text,
            MeshNormals normals = MeshNormals::shown);

  [[nodiscard]] const GltfDocument& document() const { return document_; }
  /// Notes that a mesh is used once more; refuses more vertices, triangles or parts than there may be,
  /// before any of them is read.
  void count(std::size_t mesh);
  /// The parts of a mesh; of a skin their bones, and a mistake where those are missing. `visit` takes a
  /// GltfPart.
  template <class Visit>
  void eachPart(std::size_t mesh, const GltfSkin& skin, const Visit& visit) const {
    forEachPrimitive(mesh, [&](const JsonValue& primitive) { visit(part(mesh, primitive, skin)); });
  }
  /// Primitives of meshes counted that are lines or points: "lines (2)".
  [[nodiscard]] std::vector<std::string> undrawn() const;
  /// The matrices of a skin's joints, given where the file's nodes are.
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
  void poseVertices(std::size_t mesh, const JsonValue& primitive, const std::vector<glm::mat4>& pose,
                    std::vector<GltfVertex>& vertices) const;
  void addBones(std::size_t mesh, const JsonValue& primitive, std::vector<GltfVertex>& vertices) const;
  [[nodiscard]] std::vector<std::array<unsigned, 3>> trianglesOf(const JsonValue& primitive,
                                                                 std::size_t vertices) const;

  GltfDocument document_;
  MeshNormals normals_;
  std::size_t vertices_ = 0, corners_ = 0, parts_ = 0;  ///< counted so far
  std::size_t points_ = 0, lines_ = 0;                  ///< primitives of them
};

/// Modes of a primitive by their numbers in glTF.
constexpr std::uint64_t triangleList = 4, triangleStrip = 5, triangleFan = 6;

template <class Visit>
void GltfParts::forEachPrimitive(std::size_t mesh, const Visit& visit) const {
  primitivesOf(mesh).eachItem([&](const JsonValue& primitive) {
    if (!primitive.has("attributes")) document_.refuse("has a primitive without attributes");
    const std::uint64_t mode = GltfDocument::number(primitive, "mode", triangleList);
    if (mode > triangleFan) document_.refuse(fmt::format("has a primitive of mode {}", mode));
    if (mode >= triangleList) visit(primitive);  // the others are points and lines
  });
}

}  // namespace simreel::sim
