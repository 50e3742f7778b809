#include "frame/mesh/glb.hpp"

#include "frame/mesh/gltf_parts.hpp"
#include "frame/mesh/named_vertices.hpp"

namespace simreel::frame {

std::vector<std::byte> encodeGlb(const sim::MeshTable& mesh, const std::string& name,
                                 std::span<const std::string> comments) {
  const sim::MeshTable named = NamedVertices(mesh).of(mesh);
  nlohmann::ordered_json document = gltfDocument(name, comments);
  GltfLayout layout;
  if (!named.indices.empty()) {
    addMesh(document, name, addSurface(layout, named), named.doubleSided);
    layout.into(document);
  }
  std::string text = document.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::vector<std::byte> file = glbHeader(text.size(), layout.bytes());
  const auto append = [&](std::span<const std::byte> bytes) {
    file.insert(file.end(), bytes.begin(), bytes.end());
  };
  append(std::as_bytes(std::span(text)));
  if (layout.bytes() == 0) return file;
  append(glbBinaryHeader(layout.bytes()));
  for (const auto& list : surfaceBytes(named)) append(list);
  return file;
}

}  // namespace simreel::frame
