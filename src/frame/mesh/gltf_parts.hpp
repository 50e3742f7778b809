#pragma once
#include "sim/core/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::frame {

/// Numbers that glTF 2.0 (Khronos, 3.6 and 5) gives to types and uses of data.
enum GltfNumber : int { gltfFloat = 5126, gltfUnsigned = 5125, gltfVertices = 34962, gltfIndices = 34963 };

/// Least and greatest coordinates, which accessors of positions have to state.
struct Bounds {
  glm::vec3 low{0}, high{0};
  [[nodiscard]] static Bounds of(std::span<const glm::vec3> points);
};

/// What a glTF document says of a binary chunk: views and accessors, in the order in which the bytes follow
/// one another. All of it are words of four bytes, so that nothing needs padding.
class GltfLayout {
 public:
  /// A view of that many bytes after those before; its number. `target`: 0 of what is no vertex and no
  /// index; `stride`: 0 where one accessor has the view.
  std::size_t view(std::uint64_t bytes, int target, int stride = 0);
  /// `type`: "SCALAR", "VEC2" or "VEC3"; its number.
  std::size_t accessor(std::size_t view, std::uint64_t offset, int component, std::size_t count,
                       const char* type);
  /// A view and its only accessor; the accessor's number.
  std::size_t list(int target, int component, std::size_t count, const char* type);
  void setBounds(std::size_t accessor, const Bounds& bounds);
  void setBounds(std::size_t accessor, float low, float high);
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Adds all of it.
  void into(nlohmann::ordered_json& document) const;

 private:
  std::uint64_t bytes_ = 0;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

/// Positions, normals, uvs where there are some, and indices of a mesh, as a primitive names them.
[[nodiscard]] nlohmann::ordered_json addSurface(GltfLayout& layout, const sim::MeshTable& mesh);
/// Their bytes in that order, a list each.
[[nodiscard]] std::vector<std::span<const std::byte>> surfaceBytes(const sim::MeshTable& mesh);

/// A document of one node with a mesh of one primitive, but for layout and buffer.
[[nodiscard]] nlohmann::ordered_json gltfDocument(const std::string& name,
                                                  std::span<const std::string> comments);
void addMesh(nlohmann::ordered_json& document, const std::string& name,
             const nlohmann::ordered_json& primitive, bool doubleSided);

/// The bytes before a document's text of `json` bytes in a GLB file (4.4 there), and before a binary chunk.
[[nodiscard]] std::vector<std::byte> glbHeader(std::uint64_t json, std::uint64_t binary);
[[nodiscard]] std::vector<std::byte> glbBinaryHeader(std::uint64_t binary);

}  // namespace simreel::frame
