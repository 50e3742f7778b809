#include "sim/mesh/buffers.hpp"

#include <atomic>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

namespace {

std::vector<glm::vec4> widened(const std::vector<glm::vec3>& items, float w) {
  std::vector<glm::vec4> wide;
  wide.reserve(items.size());
  for (const glm::vec3& item : items) wide.emplace_back(item, w);
  return wide;
}

unsigned nextNumber() {
  static std::atomic<unsigned> last = 0;
  return ++last;
}

}  // namespace

MeshTable placed(std::span<const glm::vec4> positions, std::span<const glm::vec4> normals,
                 const glm::mat4& model) {
  MeshTable table;
  table.positions.reserve(positions.size());
  table.normals.reserve(normals.size());
  for (const glm::vec4& p : positions) table.positions.emplace_back(model * glm::vec4(glm::vec3(p), 1.0F));
  for (const glm::vec4& n : normals)
    table.normals.push_back(glm::normalize(glm::vec3(model * glm::vec4(glm::vec3(n), 0.0F))));
  return table;
}

MeshTopology::MeshTopology(const std::string& name, const Mesh& mesh)
    : hasUvs_(!mesh.uvs.empty()),
      vertexCount_(static_cast<int>(mesh.positions.size())),
      indexCount_(static_cast<int>(mesh.indices.size())) {
  const std::vector<glm::vec2> none(mesh.uvs.empty() ? mesh.positions.size() : 0, glm::vec2(0));
  uvs_ = gl::Buffer::ofTexels<glm::vec2>(name + " uvs", mesh.uvs.empty() ? none : mesh.uvs);
  indices_ = gl::Buffer::ofTexels<unsigned>(name + " indices", mesh.indices);
  uvView_ = gl::Texture::view(name + " uvs", GL_RG32F, uvs_, sizeof(glm::vec2));
  if (mesh.colors.empty()) return;
  colors_ = gl::Buffer::ofTexels<glm::vec4>(name + " colours", widened(mesh.colors, 1.0F));
  colorView_ = gl::Texture::view(name + " colours", GL_RGBA32F, colors_);
}

Surface MeshTopology::surface() const {
  Surface surface;
  surface.uvs = &uvView_;
  if (colors_.name() != 0) surface.colors = &colorView_;
  surface.vertexCount = vertexCount_;
  surface.indices = &indices_;
  surface.indexCount = indexCount_;
  return surface;
}

void MeshTopology::complete(MeshTable& table) const {
  if (hasUvs_) table.uvs = uvs_.readAll<glm::vec2>();
  table.indices = indices_.readAll<unsigned>();
}

MeshBuffers::MeshBuffers(const std::string& name, const Mesh& mesh)
    : number_(nextNumber()), topology_(name, mesh) {
  positions_ = gl::Buffer::ofTexels<glm::vec4>(name + " positions", widened(mesh.positions, 1.0F));
  normals_ = gl::Buffer::ofTexels<glm::vec4>(name + " normals", widened(mesh.normals, 0.0F));
  positionView_ = gl::Texture::view(name + " positions", GL_RGBA32F, positions_);
  normalView_ = gl::Texture::view(name + " normals", GL_RGBA32F, normals_);
}

Surface MeshBuffers::surface() const {
  Surface surface = topology_.surface();
  surface.positions = &positionView_;
  surface.normals = &normalView_;
  surface.still = number_;
  return surface;
}

MeshTable MeshBuffers::table(const glm::mat4& model) const {
  MeshTable table = placed(positions_.readAll<glm::vec4>(), normals_.readAll<glm::vec4>(), model);
  topology_.complete(table);
  return table;
}

}  // namespace simreel::sim
