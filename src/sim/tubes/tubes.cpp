#include "sim/tubes/tubes.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/grid/color_map.hpp"

#include <cstddef>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr int paletteRoom = 256;

/// Returns the triangles of all tubes: bands between consecutive rings of each line.
std::vector<unsigned> bands(int lines, int rings) {
  std::vector<unsigned> indices;
  indices.reserve(static_cast<std::size_t>(lines) * static_cast<std::size_t>(rings - 1) * 6 * Tubes::sides);
  for (int line = 0; line < lines; ++line)
    for (int ring = 0; ring + 1 < rings; ++ring)
      for (int side = 0; side < Tubes::sides; ++side) {
        const int first = (line * rings + ring) * Tubes::sides;
        const auto a = static_cast<unsigned>(first + side),
                   b = static_cast<unsigned>(first + (side + 1) % Tubes::sides);
        indices.insert(indices.end(), {a, b, b + Tubes::sides, a, b + Tubes::sides, a + Tubes::sides});
      }
  return indices;
}

}  // namespace

Tubes::Tubes(const std::string& name, int lines, int points, const std::vector<glm::vec3>& stops, bool fast)
    : lines_(lines), points_(points), kernel_(gl::kernelDefines(fast)) {
  const int count = lines * (points + 2) * sides;
  vertices_ = gl::Vec4Array(name + " vertices", count);
  normals_ = gl::Vec4Array(name + " normals", count);
  colors_ = gl::Vec4Array(name + " colours", count);
  paletteSize_ = stops.size() == 1 ? 1 : paletteRoom;
  palette_ = gl::Vec4Array(name + " palette", stops.size() == 1
                                                  ? std::vector<glm::vec4>{glm::vec4(stops.front(), 1)}
                                                  : paletteOf(stops, paletteRoom));
  const std::vector<glm::vec2> none(static_cast<std::size_t>(count), glm::vec2(0));
  uvs_ = gl::Buffer::ofTexels<glm::vec2>(name + " texture coordinates", none);
  uvView_ = gl::Texture::view(name + " texture coordinates", GL_RG32F, uvs_, sizeof(glm::vec2));
  const std::vector<unsigned> indices = bands(lines, points + 2);
  indexCount_ = static_cast<int>(indices.size());
  indices_ = gl::Buffer::ofTexels<unsigned>(name + " indices", indices);
  const unsigned all[] = {static_cast<unsigned>(indexCount_), 1, 0, 0, 0};
  arguments_ = gl::Buffer::of<unsigned>(name + " arguments", all);
  for (int i = 0; i < sides; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / sides;
    circle_.emplace_back(shader::exactCos(angle), shader::exactSin(angle));
  }
}

void Tubes::make(const gl::Vec4Array& points, const gl::Buffer& spans, const Look& look) {
  kernel_.dispatch(lines_, {.lines = lines_,
                            .room = points_,
                            .radius = look.radius,
                            .taperFirst = look.taperFirst > 0 ? 1 / look.taperFirst : 1e6F,
                            .taperLast = look.taperLast > 0 ? 1 / look.taperLast : 1e6F,
                            .fade = look.fade,
                            .paletteSize = paletteSize_,
                            .circle = circle_,
                            .points = points,
                            .spans = spans,
                            .palette = palette_,
                            .vertices = vertices_,
                            .normals = normals_,
                            .colors = colors_});
  gl::barrier();
}

Surface Tubes::surface(const scene::Material& material) const {
  Surface surface;
  surface.positions = &vertices_.view();
  surface.normals = &normals_.view();
  surface.colors = &colors_.view();
  surface.uvs = &uvView_;
  surface.vertexCount = lines_ * (points_ + 2) * sides;
  surface.indices = &indices_;
  surface.indexCount = indexCount_;
  surface.arguments = &arguments_;
  surface.material = &material;
  return surface;
}

MeshTable Tubes::table() const {
  MeshTable table;
  for (const glm::vec4& p : vertices_.buffer().readAll<glm::vec4>()) table.positions.emplace_back(p);
  for (const glm::vec4& n : normals_.buffer().readAll<glm::vec4>()) table.normals.emplace_back(n);
  const auto all = indices_.readAll<unsigned>();
  for (std::size_t i = 0; i + 2 < all.size(); i += 3) {
    const glm::vec3 &a = table.positions[all[i]], &b = table.positions[all[i + 1]],
                    &c = table.positions[all[i + 2]];
    if (glm::cross(b - a, c - a) == glm::vec3(0)) continue;
    table.indices.insert(table.indices.end(), {all[i], all[i + 1], all[i + 2]});
  }
  return table;
}

}  // namespace simreel::sim
