#include "frame/mesh/gltf_parts.hpp"

#include "base/error.hpp"
#include "base/version.hpp"

#include <bit>

#include <glm/common.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "words are written as they lie in memory");

void append(std::vector<std::byte>& bytes, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(word >> (8 * i) & 255U));
}

void append(std::vector<std::byte>& bytes, const char (&word)[5]) {
  for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::byte>(word[i]));
}

}  // namespace

Bounds Bounds::of(std::span<const glm::vec3> points) {
  Bounds bounds{points.front(), points.front()};
  for (const glm::vec3& p : points) {
    bounds.low = glm::min(bounds.low, p);
    bounds.high = glm::max(bounds.high, p);
  }
  return bounds;
}

std::size_t GltfLayout::view(std::uint64_t bytes, int target, int stride) {
  SIMREEL_CHECK(bytes > 0 && bytes % 4 == 0);
  views_.push_back({{"buffer", 0}, {"byteOffset", bytes_}, {"byteLength", bytes}});
  if (stride != 0) views_.back()["byteStride"] = stride;
  if (target != 0) views_.back()["target"] = target;
  bytes_ += bytes;
  return views_.size() - 1;
}

std::size_t GltfLayout::accessor(std::size_t view, std::uint64_t offset, int component, std::size_t count,
                                 const char* type) {
  accessors_.push_back({{"bufferView", view}});
  if (offset != 0) accessors_.back()["byteOffset"] = offset;
  accessors_.back().update({{"componentType", component}, {"count", count}, {"type", type}});
  return accessors_.size() - 1;
}

std::size_t GltfLayout::list(int target, int component, std::size_t count, const char* type) {
  const std::string name = type;
  const std::uint64_t words = name == "VEC3" ? 3 : name == "VEC2" ? 2 : 1;
  return accessor(view(4 * words * count, target), 0, component, count, type);
}

void GltfLayout::setBounds(std::size_t accessor, const Bounds& bounds) {
  accessors_[accessor]["min"] = {bounds.low.x, bounds.low.y, bounds.low.z};
  accessors_[accessor]["max"] = {bounds.high.x, bounds.high.y, bounds.high.z};
}

void GltfLayout::setBounds(std::size_t accessor, float low, float high) {
  accessors_[accessor]["min"] = Json::array({low});
  accessors_[accessor]["max"] = Json::array({high});
}

void GltfLayout::into(Json& document) const {
  document["accessors"] = accessors_;
  document["bufferViews"] = views_;
  document["buffers"] = {{{"byteLength", bytes_}}};
}

Json addSurface(GltfLayout& layout, const sim::MeshTable& mesh) {
  const std::size_t count = mesh.positions.size();
  const std::size_t positions = layout.list(gltfVertices, gltfFloat, count, "VEC3");
  layout.setBounds(positions, Bounds::of(mesh.positions));
  Json attributes = {{"POSITION", positions},
                     {"NORMAL", layout.list(gltfVertices, gltfFloat, count, "VEC3")}};
  if (!mesh.uvs.empty()) attributes["TEXCOORD_0"] = layout.list(gltfVertices, gltfFloat, count, "VEC2");
  return {{"attributes", attributes},
          {"indices", layout.list(gltfIndices, gltfUnsigned, mesh.indices.size(), "SCALAR")}};
}

std::vector<std::span<const std::byte>> surfaceBytes(const sim::MeshTable& mesh) {
  return {std::as_bytes(std::span(mesh.positions)), std::as_bytes(std::span(mesh.normals)),
          std::as_bytes(std::span(mesh.uvs)), std::as_bytes(std::span(mesh.indices))};
}

Json gltfDocument(const std::string& name, std::span<const std::string> comments) {
  Json document = {{"asset", {{"version", "2.0"}, {"generator", fmt::format("simreel {}", version())}}}};
  if (!comments.empty())
    document["asset"]["extras"]["comments"] = std::vector<std::string>(comments.begin(), comments.end());
  document["scene"] = 0;
  document["scenes"] = {{{"nodes", {0}}}};
  document["nodes"] = {{{"name", name}}};
  return document;
}

void addMesh(Json& document, const std::string& name, const Json& primitive, bool doubleSided) {
  document["nodes"][0]["mesh"] = 0;
  document["meshes"] = {{{"name", name}, {"primitives", Json::array({primitive})}}};
  if (!doubleSided) return;
  document["meshes"][0]["primitives"][0]["material"] = 0;
  document["materials"] = {{{"name", name}, {"doubleSided", true}}};
}

std::vector<std::byte> glbHeader(std::uint64_t json, std::uint64_t binary) {
  constexpr std::uint64_t header = 12, chunkHeader = 8;
  std::vector<std::byte> bytes;
  append(bytes, "glTF");
  append(bytes, 2);
  append(bytes,
         static_cast<std::uint32_t>(header + chunkHeader + json + (binary > 0 ? chunkHeader + binary : 0)));
  append(bytes, static_cast<std::uint32_t>(json));
  append(bytes, "JSON");
  return bytes;
}

std::vector<std::byte> glbBinaryHeader(std::uint64_t binary) {
  std::vector<std::byte> bytes;
  append(bytes, static_cast<std::uint32_t>(binary));
  append(bytes, "BIN\0");
  return bytes;
}

}  // namespace simreel::frame
