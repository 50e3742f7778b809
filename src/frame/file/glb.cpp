#include "frame/file/glb.hpp"

#include "base/version.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

constexpr int floatType = 5126, unsignedType = 5125;  // component types of accessors
constexpr int vertexTarget = 34962, indexTarget = 34963;

/// The vertices that triangles name, in their order, and the triangles of those.
sim::MeshTable compacted(const sim::MeshTable& mesh) {
  std::vector<unsigned> place(mesh.positions.size(), 0);
  for (const unsigned i : mesh.indices) place[i] = 1;
  sim::MeshTable kept;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) continue;
    place[i] = static_cast<unsigned>(kept.positions.size());
    kept.positions.push_back(mesh.positions[i]);
    kept.normals.push_back(mesh.normals[i]);
    if (!mesh.uvs.empty()) kept.uvs.push_back(mesh.uvs[i]);
  }
  for (const unsigned i : mesh.indices) kept.indices.push_back(place[i]);
  return kept;
}

/// The binary chunk and what the document says of its parts.
class Parts {
 public:
  template <class Item>
  Json& add(const std::vector<Item>& items, int target, int component, const char* type) {
    const auto bytes = std::as_bytes(std::span(items));
    views.push_back(
        {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}, {"target", target}});
    data.insert(data.end(), bytes.begin(), bytes.end());
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", component},
                         {"count", bytes.size() / (type == std::string("SCALAR") ? 4 : sizeof(Item))},
                         {"type", type}});
    return accessors.back();
  }
  std::vector<std::byte> data;
  Json views = Json::array(), accessors = Json::array();
};

void append(std::vector<std::byte>& file, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::byte>(word >> (8 * i) & 255U));
}

void appendChunk(std::vector<std::byte>& file, const char* type, std::span<const std::byte> data,
                 char filler) {
  const std::size_t padded = (data.size() + 3) / 4 * 4;
  append(file, static_cast<std::uint32_t>(padded));
  for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::byte>(type[i]));
  file.insert(file.end(), data.begin(), data.end());
  file.resize(file.size() + padded - data.size(), static_cast<std::byte>(filler));
}

}  // namespace

std::vector<std::byte> encodeGlb(const sim::MeshTable& mesh, const std::string& name,
                                 std::span<const std::string> comments) {
  const sim::MeshTable kept = compacted(mesh);
  Parts parts;
  Json attributes;
  Json document = {{"asset", {{"version", "2.0"}, {"generator", fmt::format("simreel {}", version())}}}};
  if (!comments.empty())
    document["asset"]["extras"]["comments"] = std::vector<std::string>(comments.begin(), comments.end());
  document["scene"] = 0;
  document["scenes"] = {{{"nodes", {0}}}};
  document["nodes"] = {{{"mesh", 0}, {"name", name}}};
  if (!kept.indices.empty()) {
    Json& positions = parts.add(kept.positions, vertexTarget, floatType, "VEC3");
    glm::vec3 low = kept.positions.front(), high = low;
    for (const glm::vec3& p : kept.positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    positions["min"] = {low.x, low.y, low.z};
    positions["max"] = {high.x, high.y, high.z};
    attributes["POSITION"] = 0;
    parts.add(kept.normals, vertexTarget, floatType, "VEC3");
    attributes["NORMAL"] = 1;
    if (!kept.uvs.empty()) {
      parts.add(kept.uvs, vertexTarget, floatType, "VEC2");
      attributes["TEXCOORD_0"] = 2;
    }
    parts.add(kept.indices, indexTarget, unsignedType, "SCALAR");
    document["meshes"] = {
        {{"name", name},
         {"primitives", {{{"attributes", attributes}, {"indices", parts.accessors.size() - 1}}}}}};
    document["accessors"] = parts.accessors;
    document["bufferViews"] = parts.views;
    document["buffers"] = {{{"byteLength", parts.data.size()}}};
  } else {
    document["nodes"] = {{{"name", name}}};
  }
  const std::string text = document.dump();
  std::vector<std::byte> file;
  for (const char c : {'g', 'l', 'T', 'F'}) file.push_back(static_cast<std::byte>(c));
  append(file, 2);
  append(file, 0);  // the length, when it is known
  appendChunk(file, "JSON", std::as_bytes(std::span(text)), ' ');
  if (!parts.data.empty()) appendChunk(file, "BIN\0", parts.data, '\0');
  const auto length = static_cast<std::uint32_t>(file.size());
  std::memcpy(&file[8], &length, 4);
  return file;
}

}  // namespace simreel::frame
