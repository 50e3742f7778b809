#pragma once
#include "sim/core/simulation.hpp"
#include "sim/world/shown_mesh.hpp"

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

/// Builds the buffer views and accessors that describe the binary chunk of a glTF file, in the order of its
/// bytes. Each view starts at a multiple of 4 bytes.
class GltfLayout {
 public:
  /// Adds a view of `bytes` bytes behind the existing views, and returns its index. `target` is 0 if the
  /// data is neither vertices nor indices. `stride` is 0 if only one accessor uses the view. The caller
  /// pads the bytes to a multiple of 4.
  std::size_t view(std::uint64_t bytes, int target, int stride = 0);
  /// Adds an accessor and returns its index. `type` is "SCALAR", "VEC2", "VEC3" or
  /// "VEC4".
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

/// Binary chunk of a glTF file and its description.
struct GltfContents {
  GltfLayout layout;
  std::vector<std::byte> bytes;

  /// Adds rows of `type` and returns the index of their accessor.
  template <class T>
  std::size_t list(std::span<const T> rows, int target, int component, const char* type) {
    const std::size_t number = layout.list(target, component, rows.size(), type);
    append(std::as_bytes(rows));
    return number;
  }
  /// Adds bytes of any length and returns the index of their buffer view.
  std::size_t file(std::span<const std::byte> file);
  void append(std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }
};

/// Adds positions, normals, optional uvs, colours and indices of a mesh. Returns one primitive without
/// material for each part, in the order of sim::MeshLooks. Parts without triangles are null.
[[nodiscard]] std::vector<nlohmann::ordered_json> addSurface(GltfContents& contents,
                                                             const sim::MeshTable& mesh,
                                                             const sim::MeshLooks& looks);

/// Returns a glTF document with one empty node. GltfLayout::into() adds the accessors and the buffer.
[[nodiscard]] nlohmann::ordered_json gltfDocument(const std::string& name,
                                                  std::span<const std::string> comments);
/// Adds an extension to extensionsUsed if it is not there yet.
void useExtension(nlohmann::ordered_json& document, const std::string& extension);

/// glbHeader() returns the bytes that precede the JSON text in a GLB file (glTF 2.0 specification, 4.4).
/// `json`: length of the JSON text in bytes. glbBinaryHeader() returns the bytes that precede the binary
/// chunk.
[[nodiscard]] std::vector<std::byte> glbHeader(std::uint64_t json, std::uint64_t binary);
[[nodiscard]] std::vector<std::byte> glbBinaryHeader(std::uint64_t binary);

}  // namespace simreel::frame
