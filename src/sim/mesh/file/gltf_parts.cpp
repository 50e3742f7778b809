#include "sim/mesh/file/gltf_parts.hpp"

#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/gltf_materials.hpp"
#include "sim/polygons/distinct.hpp"

#include <bit>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace simreel::sim {

namespace {

/// Maximum number of primitives over all nodes.
constexpr std::size_t maxParts = 100'000;
/// Maximum deviation of the sum of a vertex' weights from 1; each 8-bit weight has an error of up to about
/// 1/255.
constexpr float weightSlack = 0.02F;

struct VertexHash {
  std::uint64_t operator()(const GltfVertex& vertex) const {
    WordHash hash;
    for (const float value : vertex.values)
      hash.add(std::bit_cast<std::uint32_t>(value == 0 ? 0.0F : value));
    for (const std::uint32_t bone : vertex.bones) hash.add(bone);
    for (const float weight : vertex.weights) hash.add(std::bit_cast<std::uint32_t>(weight));
    return hash.value();
  }
};

std::uint64_t modeOf(const JsonValue& primitive) {
  return GltfDocument::number(primitive, "mode", triangleList);
}

glm::vec3 placeIn(const GltfVertex& vertex) {
  return {vertex.values[0], vertex.values[1], vertex.values[2]};
}

void setNormal(GltfVertex& vertex, const glm::vec3& normal) {
  for (int k = 0; k < 3; ++k) vertex.values[3 + static_cast<std::size_t>(k)] = normal[k];
}

/// Returns the normal of a triangle, or 0 if its area is 0.
glm::vec3 normalOf(const GltfVertex& a, const GltfVertex& b, const GltfVertex& c) {
  const glm::dvec3 from(placeIn(a));
  const glm::dvec3 normal = glm::cross(glm::dvec3(placeIn(b)) - from, glm::dvec3(placeIn(c)) - from);
  const double length = glm::length(normal);
  return length > 0 && std::isfinite(length) ? glm::vec3(normal / length) : glm::vec3(0);
}

std::size_t position(const JsonValue& primitive) {
  return GltfDocument::number(primitive.at("attributes"), "POSITION");
}

}  // namespace

GltfParts::GltfParts(const std::filesystem::path& file, std::string_view text, MeshNormals normals)
    : document_(file, text), normals_(normals) {
  checkExtensions();
}

/// Rejects a file with required extensions other than KHR_mesh_quantization and the extensions that affect
/// only appearance or lights.
void GltfParts::checkExtensions() const {
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

JsonValue GltfParts::primitivesOf(std::size_t mesh) const {
  return document_.item("meshes", mesh).at("primitives");
}

void GltfParts::count(std::size_t mesh) {
  parts_ += primitivesOf(mesh).size();
  if (parts_ > maxParts) document_.refuse(fmt::format("has more than {} parts; join them", maxParts));
  primitivesOf(mesh).eachItem([&](const JsonValue& primitive) {
    const std::uint64_t mode = modeOf(primitive);
    if (mode == 0) ++points_;
    if (mode > 0 && mode < triangleList) ++lines_;
  });
  forEachPrimitive(mesh, [&](const JsonValue& primitive) {
    checkCompression(primitive);
    vertices_ += document_.count(position(primitive));
    corners_ += cornerCount(primitive);
    if (vertices_ > maxMeshItems || corners_ > 3 * maxMeshItems)
      document_.refuse(fmt::format("has more than {} vertices or triangles; simplify it", maxMeshItems));
  });
}

std::size_t GltfParts::cornerCount(const JsonValue& primitive) const {
  const std::size_t count = document_.count(
      primitive.has("indices") ? GltfDocument::number(primitive, "indices") : position(primitive));
  return modeOf(primitive) == triangleList ? count : 3 * count;
}

/// Returns an attribute's values for each vertex; empty if the primitive does not have it.
std::vector<float> GltfParts::attribute(const JsonValue& primitive, const char* name,
                                        std::size_t components, std::size_t vertices) const {
  const JsonValue attributes = primitive.at("attributes");
  if (!attributes.has(name)) return {};
  const std::size_t accessor = GltfDocument::number(attributes, name);
  if (document_.count(accessor) != vertices)
    document_.refuse(fmt::format("has a {} with values for {} of {} vertices", name,
                                 document_.count(accessor), vertices));
  return document_.floats(accessor, components);
}

/// Rejects a primitive whose vertices exist only in compressed form.
void GltfParts::checkCompression(const JsonValue& primitive) const {
  const auto extensions = primitive.find("extensions");
  const bool draco = extensions && extensions->has("KHR_draco_mesh_compression");
  if (draco && !document_.item("accessors", position(primitive)).has("bufferView"))
    document_.refuse(
        "has its vertices only in KHR_draco_mesh_compression, which is not read; export it without");
}

GltfPart GltfParts::part(std::size_t mesh, const JsonValue& primitive, const GltfSkin& skin) const {
  checkCompression(primitive);
  const std::size_t count = document_.count(position(primitive));
  const std::vector<float> positions = attribute(primitive, "POSITION", 3, count);
  const std::vector<float> normals = attribute(primitive, "NORMAL", 3, count);
  const std::size_t materials = document_.size("materials");
  const std::uint64_t material = GltfDocument::number(primitive, "material", materials);
  if (material > materials)
    document_.refuse(fmt::format("names number {} of its {} materials", material, materials));
  const std::uint64_t set = material < materials ? uvSetOf(document_, material) : 0;
  const std::vector<float> uvs = attribute(primitive, fmt::format("TEXCOORD_{}", set).c_str(), 2, count);
  std::vector<float> colors;
  std::size_t each = 3;
  if (const JsonValue attributes = primitive.at("attributes"); attributes.has("COLOR_0")) {
    each = document_.components(GltfDocument::number(attributes, "COLOR_0")) == 4 ? 4 : 3;
    colors = attribute(primitive, "COLOR_0", each, count);
  }
  std::vector<GltfVertex> all(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      all[i].values[k] = positions[3 * i + k];
      if (!normals.empty()) all[i].values[3 + k] = normals[3 * i + k];
      if (k < 2 && !uvs.empty()) all[i].values[6 + k] = uvs[2 * i + k];
      if (!colors.empty()) all[i].values[8 + k] = colors[each * i + k];
    }
  morph(mesh, primitive, skin.morphs, all);
  if (skin.kept) addBones(mesh, primitive, all);
  if (!skin.pose.empty()) poseVertices(mesh, primitive, skin.pose, all);
  GltfPart part;
  part.hasUvs = !uvs.empty();
  part.hasColors = !colors.empty();
  for (std::size_t i = 3; each == 4 && i < colors.size(); i += 4) part.fades = part.fades || colors[i] < 1;
  if (material < materials) part.material = static_cast<int>(material);
  part.triangles = trianglesOf(primitive, count);
  Distinct<GltfVertex, VertexHash> distinct;
  if (normals.empty() && normals_ == MeshNormals::shown) {
    for (auto& triangle : part.triangles) {
      const glm::vec3 normal = normalOf(all[triangle[0]], all[triangle[1]], all[triangle[2]]);
      for (unsigned& corner : triangle) {
        GltfVertex vertex = all[corner];
        setNormal(vertex, normal);
        corner = distinct.number(vertex).first;
      }
    }
  } else {
    std::vector<unsigned> numbers;
    numbers.reserve(count);
    for (const GltfVertex& vertex : all) numbers.push_back(distinct.number(vertex).first);
    for (auto& triangle : part.triangles)
      for (unsigned& corner : triangle) corner = numbers[corner];
  }
  part.vertices = distinct.release();
  return part;
}

std::vector<std::string> GltfParts::undrawn() const {
  std::vector<std::string> found;
  if (lines_ > 0) found.push_back(fmt::format("lines ({})", lines_));
  if (points_ > 0) found.push_back(fmt::format("points ({})", points_));
  if (const std::size_t bytes = document_.bytesBehind(); bytes > 0)
    found.push_back(fmt::format("bytes behind the end that its header names ({})", bytes));
  return found;
}

std::vector<glm::mat4> GltfParts::poseOf(std::uint64_t skin,
                                         const std::vector<std::optional<glm::mat4>>& nodes) const {
  const JsonValue described = document_.item("skins", skin);
  const std::vector<std::uint64_t> joints = GltfDocument::wholeNumbers(described, "joints");
  if (joints.empty()) document_.refuse(fmt::format("has a skin without joints (number {})", skin));
  std::vector<float> binds;
  if (described.has("inverseBindMatrices")) {
    binds = document_.floats(GltfDocument::number(described, "inverseBindMatrices"), 16);
    if (binds.size() < 16 * joints.size())
      document_.refuse(fmt::format("has a skin of {} joints with {} inverse bind matrices", joints.size(),
                                   binds.size() / 16));
  }
  std::vector<glm::mat4> pose;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i] >= nodes.size() || !nodes[joints[i]])
      document_.refuse(fmt::format(
          "has a skin whose joint {} is node {}, which is not in its default scene", i, joints[i]));
    pose.push_back(binds.empty() ? *nodes[joints[i]] : *nodes[joints[i]] * glm::make_mat4(&binds[16 * i]));
  }
  return pose;
}

/// Adds the displacements of morph targets, multiplied by their weights (glTF 2.0, 3.7.2.2). A node's
/// weights replace the mesh's weights.
void GltfParts::morph(std::size_t mesh, const JsonValue& primitive, const std::vector<float>& weights,
                      std::vector<GltfVertex>& vertices) const {
  const auto targets = primitive.find("targets");
  if (!targets) return;
  std::vector<float> used = weights;
  if (used.empty())
    used = GltfDocument::numbers(document_.item("meshes", mesh), "weights", targets->size());
  if (!used.empty() && used.size() != targets->size())
    document_.refuse(fmt::format("has {} weights for the {} morph targets of its mesh {}", used.size(),
                                 targets->size(), mesh));
  for (std::size_t target = 0; target < used.size(); ++target) {
    if (used[target] == 0) continue;
    const JsonValue attributes = targets->at(target);
    for (const auto& [name, first] : {std::pair("POSITION", std::size_t{0}), {"NORMAL", std::size_t{3}}}) {
      if (!attributes.has(name)) continue;
      const std::size_t accessor = GltfDocument::number(attributes, name);
      if (document_.count(accessor) != vertices.size())
        document_.refuse(fmt::format("has a morph target with a {} for {} of {} vertices", name,
                                     document_.count(accessor), vertices.size()));
      const std::vector<float> moved = document_.floats(accessor, 3);
      for (std::size_t i = 0; i < vertices.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          vertices[i].values[first + k] += used[target] * moved[3 * i + k];
    }
  }
}

/// Moves vertices by a pose, using all sets of joints and weights. A vertex without weights does not move.
void GltfParts::poseVertices(std::size_t mesh, const JsonValue& primitive,
                             const std::vector<glm::mat4>& pose, std::vector<GltfVertex>& vertices) const {
  const auto refuse = [&](const std::string& why) {
    document_.refuse(fmt::format("has a skin for its mesh {}, {}", mesh, why));
  };
  std::vector<glm::mat4> moved(vertices.size(), glm::mat4(0));
  std::vector<float> sums(vertices.size(), 0.0F);
  constexpr int sets = 8;
  for (int set = 0; set < sets; ++set) {
    const std::vector<float> bones =
        attribute(primitive, fmt::format("JOINTS_{}", set).c_str(), 4, vertices.size());
    const std::vector<float> weights =
        attribute(primitive, fmt::format("WEIGHTS_{}", set).c_str(), 4, vertices.size());
    if (bones.size() != weights.size() || (set == 0 && bones.empty()))
      refuse(fmt::format("which lacks JOINTS_{0} or WEIGHTS_{0}", set));
    for (std::size_t i = 0; i < bones.size(); ++i) {
      const float weight = weights[i], bone = bones[i];
      if (weight == 0) continue;  // skips joints with zero weight, whose index may be invalid
      if (!(weight > 0 && weight <= 2))
        refuse(fmt::format("whose vertex {} has the weight {}", i / 4, weight));
      if (!(bone >= 0 && bone < static_cast<float>(pose.size())))
        refuse(fmt::format("whose vertex {} follows joint {} of {}", i / 4, bone, pose.size()));
      moved[i / 4] += weight * pose[static_cast<std::size_t>(bone)];
      sums[i / 4] += weight;
    }
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (sums[i] == 0) continue;
    auto& v = vertices[i].values;
    const glm::mat4 matrix = moved[i] / sums[i];
    const glm::vec3 place = glm::vec3(matrix * glm::vec4(placeIn(vertices[i]), 1));
    const glm::vec3 normal = glm::transpose(glm::inverse(glm::mat3(matrix))) * glm::vec3(v[3], v[4], v[5]);
    for (int k = 0; k < 3; ++k) v[static_cast<std::size_t>(k)] = place[k];
    setNormal(vertices[i], normal);
  }
}

void GltfParts::addBones(std::size_t mesh, const JsonValue& primitive,
                         std::vector<GltfVertex>& vertices) const {
  const auto refuse = [&](const std::string& why) {
    document_.refuse(fmt::format("has a skin for its mesh {}, {}", mesh, why));
  };
  for (const char* name : {"JOINTS_0", "WEIGHTS_0"})
    if (!primitive.at("attributes").has(name))
      refuse(fmt::format("which has no {}; give its vertices weights", name));
  for (const char* name : {"JOINTS_1", "WEIGHTS_1"})
    if (primitive.at("attributes").has(name))
      refuse("of which vertices follow more than four bones; export at most four");
  const std::vector<float> bones = attribute(primitive, "JOINTS_0", 4, vertices.size());
  const std::vector<float> weights = attribute(primitive, "WEIGHTS_0", 4, vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    float sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const float bone = bones[4 * i + k];
      const float weight = weights[4 * i + k];
      if (!(weight >= 0 && weight <= 2))
        refuse(fmt::format("whose vertex {} has the weight {}", i, weight));
      if (!(bone >= 0 && bone < 65536 && bone == std::floor(bone)))
        refuse(fmt::format("whose vertex {} follows the joint {}, which is not a whole number", i, bone));
      sum += weight;
      if (weight == 0) continue;  // skips joints with zero weight, whose index may be invalid
      vertices[i].bones[k] = static_cast<std::uint32_t>(bone);
      vertices[i].weights[k] = weight;
    }
    if (!(std::abs(sum - 1) <= weightSlack))
      refuse(fmt::format("whose vertex {} has weights with the sum {}, which has to be 1", i, sum));
    for (float& weight : vertices[i].weights) weight /= sum;
  }
}

std::vector<std::array<unsigned, 3>> GltfParts::trianglesOf(const JsonValue& primitive,
                                                            std::size_t vertices) const {
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
    if (mode == triangleFan)  // all triangles of a fan share the first vertex
      triangles.push_back({corners[0], corners[i + 1], corners[i + 2]});
    else if (mode == triangleStrip && i % 2 == 1)  // every other triangle of a strip has reversed winding
      triangles.push_back({corners[i], corners[i + 2], corners[i + 1]});
    else
      triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  return triangles;
}

std::vector<float> morphsOf(const JsonValue& node) {
  return GltfDocument::numbers(node, "weights");
}

void addVertex(MeshBuilder& builder, const GltfPart& part, const GltfVertex& vertex) {
  const auto& v = vertex.values;
  const glm::vec3 position(v[0], v[1], v[2]), normal(v[3], v[4], v[5]);
  if (part.hasColors)
    builder.vertex(position, normal, {v[6], v[7]}, {v[8], v[9], v[10]});
  else
    builder.vertex(position, normal, {v[6], v[7]});
}

}  // namespace simreel::sim
