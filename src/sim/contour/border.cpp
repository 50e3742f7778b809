#include "sim/contour/border.hpp"

#include "sim/contour/solid.hpp"

#include <utility>

namespace simreel::sim {

namespace {

// Number of colours per class, and index of a class's face colour, as in glsl/contour/vertices.glsl.
constexpr int classColors = 5;
constexpr int faceColor = 0;
constexpr int wallFootColor = 3;
constexpr int wallTopColor = 4;

/// Returns the samples at the border, counterclockwise as seen from above, starting at (0, 0) and first
/// along the left side.
std::vector<glm::ivec2> ringOf(glm::ivec2 samples) {
  const glm::ivec2 end = samples - 1;
  std::vector<glm::ivec2> ring;
  ring.reserve(2 * static_cast<std::size_t>(end.x + end.y));
  for (int y = 0; y < end.y; ++y) ring.emplace_back(0, y);
  for (int x = 0; x < end.x; ++x) ring.emplace_back(x, end.y);
  for (int y = end.y; y > 0; --y) ring.emplace_back(end.x, y);
  for (int x = end.x; x > 0; --x) ring.emplace_back(x, 0);
  return ring;
}

class Builder {
 public:
  Builder(const SolidShape& shape, unsigned firstVertex)
      : shape_(shape), first_(firstVertex), ring_(ringOf(shape.size + 2)) {}

  /// Adds vertical strips along the four sides, with hard edges at the corners.
  void sides(float bottom, float top) {
    const int color = classColors * shape_.outside;
    const glm::vec3 normals[] = {{-1, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}};
    const int lengths[] = {shape_.size.y + 1, shape_.size.x + 1, shape_.size.y + 1, shape_.size.x + 1};
    std::size_t begin = 0;
    for (int side = 0; side < 4; ++side) {
      for (int i = 0; i <= lengths[side]; ++i) {
        const glm::ivec2 at = ring_[(begin + static_cast<std::size_t>(i)) % ring_.size()];
        const unsigned foot = add(at, bottom, color + wallFootColor, normals[side]);
        const unsigned head = add(at, top, color + wallTopColor, normals[side]);
        if (i == 0) continue;
        triangle(foot - 2, foot, head);
        triangle(foot - 2, head, head - 2);
      }
      begin += static_cast<std::size_t>(lengths[side]);
    }
  }

  /// Adds a horizontal face over the whole area, as a fan around its centre.
  void lid(float height, bool up) {
    const int color = classColors * shape_.outside + faceColor;
    const glm::vec3 normal(0, up ? 1 : -1, 0);
    const glm::vec2 middle(0.5F * glm::vec2(shape_.size + 1));
    const unsigned center = add(middle, height, color, normal);
    for (const glm::ivec2& at : ring_) static_cast<void>(add(at, height, color, normal));
    const auto count = static_cast<unsigned>(ring_.size());
    for (unsigned i = 0; i < count; ++i) {
      const unsigned here = center + 1 + i;
      const unsigned next = center + 1 + (i + 1) % count;
      if (up)
        triangle(center, here, next);
      else
        triangle(center, next, here);
    }
  }

  [[nodiscard]] SolidBorder release() { return std::move(border_); }

 private:
  unsigned add(glm::vec2 at, float height, int color, glm::vec3 normal) {
    const glm::vec2 place = solidCorner(shape_) + shape_.spacing * at;
    border_.positions.emplace_back(place.x, height, place.y, static_cast<float>(color));
    border_.normals.emplace_back(normal, 0);
    return first_ + static_cast<unsigned>(border_.positions.size()) - 1;
  }
  void triangle(unsigned a, unsigned b, unsigned c) {
    border_.indices.insert(border_.indices.end(), {a, b, c});
  }

  const SolidShape& shape_;
  unsigned first_;
  std::vector<glm::ivec2> ring_;
  SolidBorder border_;
};

}  // namespace

glm::vec2 solidCorner(const SolidShape& shape) {
  return -0.5F * shape.spacing * glm::vec2(shape.size + 1);
}

SolidBorder solidBorder(const SolidShape& shape, const std::vector<float>& heights, unsigned firstVertex) {
  Builder builder(shape, firstVertex);
  const float bottom = heights.front() - shape.base;
  const float top = heights[static_cast<std::size_t>(shape.outside)] + (shape.ceiling ? shape.roof : 0.0F);
  builder.sides(bottom, top);
  builder.lid(bottom, false);
  if (shape.ceiling) builder.lid(top, true);
  return builder.release();
}

}  // namespace simreel::sim
