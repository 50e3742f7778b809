#include "reference/isosurface_twin.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/volume/cubes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <glm/vector_relational.hpp>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/contour/model.glsl"
#include "glsl/volume/model.glsl"
}  // namespace simreel::shader
#undef precise
#undef FUNCTION

using namespace simreel;

namespace {

using CellValue = std::function<float(int, int, int)>;

class Marching {
 public:
  Marching(const sim::IsosurfaceShape& shape, float level, const CellValue& value, const CellValue& tint,
           glm::vec2 range)
      : shape_(shape),
        level_(level),
        value_(value),
        tint_(tint),
        range_(range),
        ring_(shape.closed ? 1 : 0) {
    const glm::ivec3 end = shape.size + ring_;
    for (int z = -ring_; z < end.z; ++z)
      for (int y = -ring_; y < end.y; ++y)
        for (int x = -ring_; x < end.x; ++x)
          for (int axis = 0; axis < 3; ++axis) addPoint({x, y, z}, axis);
    for (int z = -ring_; z + 1 < end.z; ++z)
      for (int y = -ring_; y + 1 < end.y; ++y)
        for (int x = -ring_; x + 1 < end.x; ++x) addCube({x, y, z});
  }
  sim::MeshTable mesh;

 private:
  [[nodiscard]] bool within(glm::ivec3 c) const {
    return c.x >= 0 && c.y >= 0 && c.z >= 0 && c.x < shape_.size.x && c.y < shape_.size.y &&
           c.z < shape_.size.z;
  }
  [[nodiscard]] float at(const CellValue& of, glm::ivec3 c) const {
    c = glm::clamp(c, glm::ivec3(0), shape_.size - 1);
    const float v = of(c.x, c.y, c.z);
    return std::isfinite(v) ? std::clamp(v, -1e20F, 1e20F) : -1e20F;
  }
  [[nodiscard]] bool inside(glm::ivec3 c) const { return within(c) && at(value_, c) >= level_; }
  [[nodiscard]] glm::vec3 slope(glm::ivec3 c) const {
    glm::vec3 s;
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 way(0);
      way[axis] = 1;
      const glm::ivec3 before = glm::max(c - way, glm::ivec3(0)),
                       after = glm::min(c + way, shape_.size - 1);
      s[axis] = shader::volumeSlope(at(value_, before), at(value_, after), after[axis] - before[axis] == 1);
    }
    return s;
  }
  void addPoint(glm::ivec3 cell, int axis) {
    glm::ivec3 way(0);
    way[axis] = 1;
    const glm::ivec3 next = cell + way;
    if (next[axis] >= shape_.size[axis] + ring_ || inside(cell) == inside(next)) return;
    numbers_[{cell.x, cell.y, cell.z, axis}] = static_cast<unsigned>(mesh.positions.size());
    const glm::vec3 along = inside(next) ? -glm::vec3(way) : glm::vec3(way);
    float part = 0.5F;
    glm::vec3 normal = along;
    if (within(cell) && within(next)) {
      part = shader::crossingPlace(at(value_, cell), at(value_, next), level_);
      normal = shader::volumeNormal(slope(cell), slope(next), part, along);
    }
    const glm::vec3 place = glm::vec3(cell) + glm::vec3(way) * part;
    mesh.positions.push_back(shader::volumePlace(shape_.corner(), shape_.spacing, place));
    mesh.normals.push_back(normal);
    mesh.uvs.emplace_back(
        shader::volumeColor(at(tint_, cell), at(tint_, next), part, range_.x, 1 / (range_.y - range_.x)),
        0);
  }
  void addCube(glm::ivec3 c) {
    int kind = 0;
    for (int i = 0; i < 8; ++i)
      if (inside(c + glm::ivec3(i & 1, i >> 1 & 1, i >> 2))) kind |= 1 << i;
    for (const auto& triangle : sim::cubeKinds()[static_cast<std::size_t>(kind)].triangles)
      for (const int edge : triangle) {
        const int axis = edge / 4, low = edge & 1, high = edge >> 1 & 1;
        const glm::ivec3 from = c + (axis == 0   ? glm::ivec3(0, low, high)
                                     : axis == 1 ? glm::ivec3(low, 0, high)
                                                 : glm::ivec3(low, high, 0));
        mesh.indices.push_back(numbers_.at({from.x, from.y, from.z, axis}));
      }
  }

  const sim::IsosurfaceShape& shape_;
  float level_;
  const CellValue& value_;
  const CellValue& tint_;
  glm::vec2 range_;
  int ring_;
  std::map<std::array<int, 4>, unsigned> numbers_;
};

}  // namespace

sim::MeshTable isosurfaceTwin(const sim::IsosurfaceShape& shape, float level, const CellValue& value,
                              const CellValue& tint, glm::vec2 range) {
  return Marching(shape, level, value, tint, range).mesh;
}

sim::MeshTable cubesTwin(const sim::IsosurfaceShape& shape, float level, const CellValue& value,
                         const CellValue& tint, glm::vec2 range) {
  sim::MeshTable mesh;
  const auto at = [&](const CellValue& of, glm::ivec3 c) {
    const float v = of(c.x, c.y, c.z);
    return std::isfinite(v) ? std::clamp(v, -1e20F, 1e20F) : -1e20F;
  };
  const auto exists = [&](glm::ivec3 c) {
    return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, shape.size));
  };
  const auto lives = [&](glm::ivec3 c) { return exists(c) && at(value, c) >= level; };
  const auto square = [&](glm::ivec3 cell, int axis, bool first) {
    const auto begin = static_cast<unsigned>(mesh.positions.size());
    glm::ivec3 way(0);
    way[axis] = 1;
    const float seen = at(tint, first ? cell : cell + way);
    constexpr int around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (const auto& [right, up] : around) {
      glm::vec3 place(cell);
      place[axis] += 0.5F;
      place[(axis + 1) % 3] += 0.5F * static_cast<float>(right);
      place[(axis + 2) % 3] += 0.5F * static_cast<float>(up);
      mesh.positions.push_back(shader::volumePlace(shape.corner(), shape.spacing, place));
      mesh.normals.push_back(first ? glm::vec3(way) : glm::vec3(-way));
      mesh.uvs.emplace_back(shader::volumeColor(seen, seen, 0, range.x, 1 / (range.y - range.x)), 0);
    }
    for (const unsigned i : {0U, first ? 1U : 3U, 2U, 0U, 2U, first ? 3U : 1U})
      mesh.indices.push_back(begin + i);
  };
  const int ring = shape.closed ? 1 : 0;
  const glm::ivec3 end = shape.size + ring;
  for (int z = -ring; z < end.z; ++z)
    for (int y = -ring; y < end.y; ++y)
      for (int x = -ring; x < end.x; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          const glm::ivec3 cell(x, y, z);
          glm::ivec3 next = cell;
          ++next[axis];
          if (next[axis] < end[axis] && lives(cell) != lives(next)) square(cell, axis, lives(cell));
        }
  return mesh;
}
