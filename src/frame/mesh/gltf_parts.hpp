#pragma once
#include "sim/core/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::frame {

/// Codes of component types and buffer targets in glTF 2.0 (Khronos, 3.6 and 5).
enum GltfNumber : int { gltfFloat = 5126, gltfUnsigned = 5125, gltfVertices = 34962, gltfIndices = 34963 };

/// Min and max coordinates, which glTF requires for accessors of positions.
struct Bounds {
  glm::vec3 low{0}, high{0};
  [[nodiscard]] static Bounds of(std::span<const glm::vec3> points);
};

/// Creates the buffer views and accessors that describe the binary chunk of a glTF file, in the order of
/// the chunk's bytes. All data consists of 4-byte words, so no padding is needed.
class GltfLayout {
 public:
  /// Adds a view of `bytes` bytes after the existing views, and returns its index. `target`: 0 if the data
  /// is neither vertices nor indices. `stride`: 0 if only one accessor uses the view.
  std::size_t view(std::uint64_t bytes, int target, int stride = 0);
  /// Adds an accessor and returns its index. `type` is "SCALAR", "VEC2" or "VEC3".
  std::size_t accessor(std::size_t view, std::uint64_t offset, int component, std::size_t count,
                       const char* type);
  /// Adds a view with a single accessor, and returns the accessor's index.
  std::size_t list(int target, int component, std::size_t count, const char* type);
  void setBounds(std::size_t accessor, const Bounds& bounds);
  void setBounds(std::size_t accessor, float low, float high);
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Writes accessors, views and the buffer into the glTF document.
  void into(nlohmann::ordered_json& document) const;

 private:
  std::uint64_t bytes_ = 0;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

/// Adds positions, normals, optional uvs and indices of a mesh to `layout`. Returns the glTF primitive that
/// refers to them.
[[nodiscard]] nlohmann::ordered_json addSurface(GltfLayout& layout, const sim::MeshTable& mesh);
/// Returns the bytes of positions, normals, uvs and indices, one span per attribute, in the order of
/// addSurface().
[[nodiscard]] std::vector<std::span<const std::byte>> surfaceBytes(const sim::MeshTable& mesh);

/// Returns a glTF document with one empty node. addMesh() gives the node a mesh with one primitive.
/// GltfLayout adds accessors and buffer.
[[nodiscard]] nlohmann::ordered_json gltfDocument(const std::string& name,
                                                  std::span<const std::string> comments);
void addMesh(nlohmann::ordered_json& document, const std::string& name,
             const nlohmann::ordered_json& primitive, bool doubleSided);

/// glbHeader() returns the bytes of a GLB file before its JSON text of `json` bytes (glTF 2.0
/// specification, 4.4). glbBinaryHeader() returns the bytes before the binary chunk.
[[nodiscard]] std::vector<std::byte> glbHeader(std::uint64_t json, std::uint64_t binary);
[[nodiscard]] std::vector<std::byte> glbBinaryHeader(std::uint64_t binary);

}  // namespace simreel::frame
