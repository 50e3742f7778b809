#include "sim/fluid/wind.hpp"

#include "base/error.hpp"
#include "gl/context.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

namespace simreel::sim {

void FluidPlane::describe(scene::Fields& f) {
  f.vector("position", position, scene::anyNumber, "m", "Middle of its rectangle.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees",
           "About x, then y, then z; unrotated it stands upright, and seen along -z it looks as "
           "in the picture.");
  f.number("cell", cell, {1e-4, 1e3}, "m", "Width of a cell.");
}

scene::Box boxOfPlane(const FluidPlane& plane, glm::ivec2 size) {
  const glm::mat4 turned = rotationMatrix(plane.rotation);
  const glm::vec3 half = 0.5F * plane.cell *
                         (glm::abs(glm::vec3(turned[0])) * static_cast<float>(size.x) +
                          glm::abs(glm::vec3(turned[1])) * static_cast<float>(size.y));
  return {plane.position - half, plane.position + half};
}

// Maps a point p to the grid coordinates x = (p - c) . ex / h + W / 2 and y = H / 2 - (p - c) . ey / h,
// where c is the centre of the rectangle, ex and ey are its axes, h is the cell width, and the grid has W x
// H cells.
shader::WindGrid fluidWindGrid(const FluidPlane& plane, glm::ivec2 size) {
  const glm::dmat4 turned(rotationMatrix(plane.rotation));
  const glm::dvec3 right(turned[0]), up(turned[1]), middle(plane.position);
  const double cell = plane.cell;
  const auto row = [&](const glm::dvec3& way, double before) {
    const double here = way.x * middle.x + way.y * middle.y + way.z * middle.z;
    return glm::vec4(way.x / cell, way.y / cell, way.z / cell, 0.5 * before - here / cell);
  };
  shader::WindGrid grid{};
  grid.across = row(right, size.x);
  grid.down = row(-up, size.y);
  grid.alongX = glm::vec3(right * cell);
  grid.alongY = glm::vec3(up * -cell);
  grid.size = size;
  return grid;
}

constinit const PortInfo FluidWind::port = {
    .name = "wind",
    .lacks = ", which does not blow",
    .none = "nothing in the scene blows; add a fluid",
};

FluidWind::FluidWind(const FluidPlane& plane, glm::ivec2 size, float speed,
                     std::function<const FluidArray&()> flow)
    : plane_(plane), grid_(fluidWindGrid(plane, size)), speed_(speed), flow_(std::move(flow)) {}

FluidWind::FluidWind(const std::string& name, const FluidPlane& plane, glm::ivec2 size,
                     std::span<const glm::vec4> cells)
    : plane_(plane),
      grid_(fluidWindGrid(plane, size)),
      speed_(0),
      flow_([this]() -> const FluidArray& { return stillFlow_; }) {
  SIMREEL_CHECK(cells.size() ==
                static_cast<std::size_t>(size.x + 2) * static_cast<std::size_t>(size.y + 2));
  for (const glm::vec4& cell : cells) speed_ = std::max(speed_, cell.z);
  std::vector<float> planes;
  for (int i = 0; i < 2; ++i)
    for (const glm::vec4& cell : cells) planes.push_back(cell[i]);
  still_ = gl::memoryPath() == gl::MemoryPath::texel
               ? gl::Buffer::ofTexels<glm::vec4>(name + " wind", cells)
               : gl::Buffer::of<float>(name + " wind", planes);
  stillFlow_ = FluidArray(name + " wind", {&still_, 0, still_.bytes()});
}

FluidWindPart FluidWind::part() const {
  return {.across = grid_.across,
          .down = grid_.down,
          .alongX = grid_.alongX,
          .alongY = grid_.alongY,
          .size = grid_.size,
          .cells = flow_().resource()};
}

}  // namespace simreel::sim
