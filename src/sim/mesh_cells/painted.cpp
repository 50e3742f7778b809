#include "sim/mesh_cells/painted.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/grid/color_map.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace simreel::shader::mesh_cells {
#include "glsl/mesh_cells/bindings.glsl"
}  // namespace simreel::shader::mesh_cells

namespace simreel::sim {

struct MeshPaintKernel {
  static constexpr auto file = "mesh_cells/paint.comp";
  gl::Uniform<"count", int> count;
  gl::Uniform<"firstWord", int> firstWord;
  gl::Uniform<"range", glm::vec2> range;
  gl::In<"cellWords"> words;
  gl::In<"rest"> rest;
  gl::Out<"PaintedBlock"> painted;
};

namespace {

std::vector<glm::uvec4> restWords(const Mesh& mesh, const MeshCells& cells) {
  std::vector<glm::uvec4> words;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    // Vertices without a face have the cell -1. They are not drawn, so any valid cell can be used for them.
    words.emplace_back(std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                       std::bit_cast<std::uint32_t>(p.z), std::max(cells.cellOf[i], 0));
  }
  return words;
}

std::vector<glm::vec4> meshNormals(const Mesh& mesh) {
  std::vector<glm::vec4> normals;
  for (const glm::vec3& normal : mesh.normals) normals.emplace_back(normal, 0);
  return normals;
}

}  // namespace

PaintedMesh::PaintedMesh(const std::string& name, const Mesh& mesh, const MeshCells& cells,
                         const std::vector<glm::vec3>& colors)
    : count_(static_cast<int>(mesh.positions.size())),
      topology_(name, mesh),
      rest_(name + " vertices at rest", restWords(mesh, cells)),
      painted_(name + " painted vertices", mesh.positions.size() * sizeof(glm::vec4)),
      normals_(gl::Buffer::of<glm::vec4>(name + " normals", meshNormals(mesh))),
      paintedView_(gl::Texture::view(name + " painted vertices", GL_RGBA32F, painted_)),
      normalView_(gl::Texture::view(name + " normals", GL_RGBA32F, normals_)),
      palette_(name + " colours", paletteOf(colors, shader::mesh_cells::meshColors)),
      paint_(gl::kernelDefines(false)) {}

void PaintedMesh::paint(const gl::Texture& words, int firstWord, glm::vec2 range) {
  gl::barrier();
  paint_.dispatch(count_, {.count = count_,
                           .firstWord = firstWord,
                           .range = glm::vec2(range.x, 1 / (range.y - range.x)),
                           .words = words,
                           .rest = rest_,
                           .painted = painted_});
  gl::barrier();
}

Surface PaintedMesh::surface() const {
  Surface surface = topology_.surface();
  surface.positions = &paintedView_;
  surface.normals = &normalView_;
  surface.palette = &palette_.view();
  return surface;
}

MeshTable PaintedMesh::table(const glm::mat4& model) const {
  MeshTable table = placed(painted_.readAll<glm::vec4>(), normals_.readAll<glm::vec4>(), model);
  topology_.complete(table);
  return table;
}

}  // namespace simreel::sim
