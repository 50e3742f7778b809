// Reads solids back as tables: meshes and contour lines.
#include "sim/contour/solid_state.hpp"
#include "sim/contour/unwrap.hpp"

namespace simreel::sim {

MeshTable Solid::mesh() const {
  const State& s = *state_;
  const auto vertices = static_cast<std::size_t>(s.firstPoint()) + 4 * std::size_t{s.found().points};
  MeshTable table;
  std::vector<glm::vec4> wide(vertices);
  const auto narrowed = [&](const gl::Buffer& buffer) {
    buffer.read(0, std::as_writable_bytes(std::span(wide)));
    return std::vector<glm::vec3>(wide.begin(), wide.end());
  };
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  table.positions = narrowed(s.positions);
  table.normals = narrowed(s.normals);
  table.indices.resize(s.found().indices);
  s.indices.read(0, std::as_writable_bytes(std::span(table.indices)));
  return table;
}

MeshTable Solid::unwrapped() const {
  const State& s = *state_;
  MeshTable table = mesh();
  unwrap(table, lines().next, static_cast<unsigned>(s.firstPoint()),
         s.shape.spacing * static_cast<float>(s.samples.x - 1));
  return table;
}

ContourLines Solid::lines() const {
  const State& s = *state_;
  const std::size_t count = s.found().points;
  std::vector<glm::vec4> vertices(4 * count);
  ContourLines lines;
  lines.size = s.shape.size;
  lines.next.resize(count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  s.positions.read(static_cast<std::size_t>(s.firstPoint()) * 16,
                   std::as_writable_bytes(std::span(vertices)));
  s.next.read(0, std::as_writable_bytes(std::span(lines.next)));
  const glm::vec2 corner = solidCorner(s.shape);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec4& wall = vertices[4 * i + 1];
    // Sample (0, 0) is one cell before the field's first cell.
    lines.points.push_back((glm::vec2(wall.x, wall.z) - corner) / s.shape.spacing - 1.0F);
    lines.levels.push_back(static_cast<int>(wall.w) / 5);
  }
  return lines;
}

}  // namespace simreel::sim
