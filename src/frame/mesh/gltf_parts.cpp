#include "frame/mesh/gltf_parts.hpp"

#include "base/error.hpp"
#include "base/version.hpp"

#include <algorithm>
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
  SIMREEL_CHECK(bytes > 0);
  views_.push_back({{"buffer", 0}, {"byteOffset", bytes_}, {"byteLength", bytes}});
  if (stride != 0) views_.back()["byteStride"] = stride;
  if (target != 0) views_.back()["target"] = target;
  bytes_ += (bytes + 3) / 4 * 4;
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
  const std::uint64_t words = name == "SCALAR" ? 1 : static_cast<std::uint64_t>(name.back() - '0');
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

std::size_t GltfContents::file(std::span<const std::byte> file) {
  const std::size_t number = layout.view(file.size(), 0);
  append(file);
  bytes.resize(layout.bytes());
  return number;
}

namespace {

/// Adds the indices of all parts to one view, part by part.
std::vector<Json> addParts(GltfContents& contents, const sim::MeshTable& mesh, const sim::MeshLooks& looks,
                           const Json& attributes) {
  const std::size_t parts = std::max<std::size_t>(1, looks.materials.size());
  std::vector<std::vector<unsigned>> indices(parts);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i)
    indices[looks.partOf.empty() ? 0 : looks.partOf[i / 3]].push_back(mesh.indices[i]);
  const std::size_t view = contents.layout.view(4 * std::uint64_t{mesh.indices.size()}, gltfIndices);
  std::vector<Json> primitives;
  std::uint64_t offset = 0;
  for (const std::vector<unsigned>& part : indices) {
    primitives.emplace_back();
    if (part.empty()) continue;
    primitives.back() = {
        {"attributes", attributes},
        {"indices", contents.layout.accessor(view, offset, gltfUnsigned, part.size(), "SCALAR")}};
    contents.append(std::as_bytes(std::span(part)));
    offset += 4 * part.size();
  }
  return primitives;
}

}  // namespace

std::vector<Json> addSurface(GltfContents& contents, const sim::MeshTable& mesh,
                             const sim::MeshLooks& looks) {
  const auto vertices = [&](const auto& rows, const char* type) {
    return contents.list(std::span(rows), gltfVertices, gltfFloat, type);
  };
  Json attributes = {{"POSITION", vertices(mesh.positions, "VEC3")}};
  contents.layout.setBounds(attributes["POSITION"], Bounds::of(mesh.positions));
  attributes["NORMAL"] = vertices(mesh.normals, "VEC3");
  if (!mesh.uvs.empty()) attributes["TEXCOORD_0"] = vertices(mesh.uvs, "VEC2");
  if (!looks.colors.empty()) attributes["COLOR_0"] = vertices(looks.colors, "VEC3");
  return addParts(contents, mesh, looks, attributes);
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

void useExtension(Json& document, const std::string& extension) {
  Json& used = document["extensionsUsed"];
  if (std::find(used.begin(), used.end(), extension) == used.end()) used.push_back(extension);
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
