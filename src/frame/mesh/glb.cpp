#include "frame/mesh/glb.hpp"

#include "frame/mesh/gltf_parts.hpp"
#include "frame/mesh/named_vertices.hpp"

#include <utility>

#include <glm/common.hpp>

namespace simreel::frame {

namespace {

using Json = nlohmann::ordered_json;

/// Returns the mean colour of the copies. It is used for emitted light, because no glTF attribute gives a
/// copy a separate emission.
glm::vec3 meanColor(const sim::ShownCopies& copies) {
  if (copies.colors.empty()) return copies.material->color;
  glm::dvec3 sum(0);
  for (const glm::vec3& color : copies.colors) sum += color;
  return glm::vec3(sum / static_cast<double>(copies.colors.size()));
}

/// Adds a node with all copies of one mesh to the document.
class CopyWriter {
 public:
  CopyWriter(Json& document, GltfContents& contents, GltfMaterials& materials)
      : document_(document), contents_(contents), materials_(materials) {}

  void add(const sim::ShownCopies& copies, const std::string& name) {
    const sim::MeshTable shape = NamedVertices(copies.shape).of(copies.shape);
    sim::MeshLooks looks;
    looks.materials = {copies.material};
    looks.ownColors = !copies.colors.empty();
    const std::vector<Json> primitives = addSurface(contents_, shape, looks);
    const Json numbers = copies.glow > 0
                             ? Json::array({materials_.addGlow(name, copies.glow * meanColor(copies))})
                             : materials_.add(shape, looks, name);
    addMesh(document_, name, primitives, numbers);
    Json attributes = {{"TRANSLATION", rows(copies.places, "VEC3")}};
    if (!copies.turns.empty()) attributes["ROTATION"] = rows(quaternions(copies), "VEC4");
    std::vector<glm::vec3> scales;
    for (const float scale : copies.scales) scales.emplace_back(scale);
    attributes["SCALE"] = rows(scales, "VEC3");
    if (!copies.colors.empty()) attributes["_COLOR_0"] = rows(copies.colors, "VEC3");
    document_["nodes"].back()["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
    useExtension(document_, "EXT_mesh_gpu_instancing");
  }

 private:
  template <class T>
  std::size_t rows(const std::vector<T>& items, const char* type) {
    return contents_.list(std::span(items), 0, gltfFloat, type);
  }
  /// Returns the rotations of the copies as quaternions in the order of glTF: x, y, z, w.
  static std::vector<glm::vec4> quaternions(const sim::ShownCopies& copies) {
    std::vector<glm::vec4> all;
    all.reserve(copies.turns.size());
    for (const glm::quat& q : copies.turns) all.emplace_back(q.x, q.y, q.z, q.w);
    return all;
  }

  Json& document_;
  GltfContents& contents_;
  GltfMaterials& materials_;
};

/// Adds an object's mesh and copies below its root node, the last node of the document.
void addObject(Json& document, GltfContents& contents, GltfMaterials& materials, const GlbObject& object) {
  const std::size_t root = document["nodes"].size() - 1;
  const NamedVertices names(object.mesh);
  const sim::MeshTable named = names.of(object.mesh);
  sim::MeshLooks looks = object.looks;
  looks.colors = names.of(object.looks.colors);
  bool empty = named.indices.empty();
  if (!empty) {
    const std::vector<Json> primitives = addSurface(contents, named, looks);
    addMesh(document, object.name, primitives, materials.add(named, looks, object.name));
  }
  CopyWriter writer(document, contents, materials);
  for (const sim::ShownCopies& one : object.copies) {
    if (!std::exchange(empty, false)) {
      document["nodes"][root]["children"].push_back(document["nodes"].size());
      document["nodes"].push_back({{"name", object.name + " copies"}});
    }
    writer.add(one, document["nodes"].back()["name"]);
  }
}

}  // namespace

std::vector<std::byte> encodeGlb(std::span<const GlbObject> objects, std::span<const std::string> comments,
                                 const SkinPicturesOf& skins) {
  Json document = gltfDocument(objects.empty() ? "empty" : objects.front().name, comments);
  GltfContents contents;
  GltfMaterials materials(document, contents, skins);
  for (const GlbObject& object : objects) {
    if (&object != objects.data()) {
      document["scenes"][0]["nodes"].push_back(document["nodes"].size());
      document["nodes"].push_back({{"name", object.name}});
    }
    addObject(document, contents, materials, object);
  }
  materials.finish();
  if (contents.layout.bytes() > 0) contents.layout.into(document);
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::vector<std::byte> file = glbHeader(text.size(), contents.layout.bytes());
  const auto append = [&](std::span<const std::byte> bytes) {
    file.insert(file.end(), bytes.begin(), bytes.end());
  };
  append(std::as_bytes(std::span(text)));
  if (contents.bytes.empty()) return file;
  append(glbBinaryHeader(contents.layout.bytes()));
  append(contents.bytes);
  return file;
}

}  // namespace simreel::frame
