#include "reference/reflections_twin.hpp"

#include "draw/picture_code.hpp"

#include <cstddef>

namespace {

using namespace simreel::shader;  // NOLINT: the model uses GLSL's names

#define FUNCTION inline
#define IF_ANY(condition) if (condition)
#define precise
#define EXACT_PICTURE
#define MIRROR_TWIN
#include "glsl/draw/exact/reflections/levels.glsl"
/// Provides the inputs of the kernels, and includes the model files.
struct MirrorKernel {
  const ReflectionsTwin& twin;
  const ExactView& view = twin.view;
  vec2 mirrorReach_ = twin.reach;
  bool refined = !twin.nearestOfPixels.empty();
  float cellsPerPixel_ = refined ? 1.0F : 0.5F;

  template <class Cell>
  [[nodiscard]] static Cell cellAt(const std::vector<Cell>& cells, ivec2 size, int level, ivec2 at) {
    const ivec2 end = levelSize(size, level);
    if (at.x < 0 || at.y < 0 || at.x >= end.x || at.y >= end.y) return Cell(0);
    return cells[static_cast<std::size_t>(levelPlace(levelRoom(size), level, at))];
  }
  template <class Cell>
  [[nodiscard]] Cell pixelAt(const std::vector<Cell>& pixels, ivec2 at) const {
    if (at.x < 0 || at.y < 0 || at.x >= view.size.x || at.y >= view.size.y) return Cell(0);
    return pixels[static_cast<std::size_t>(at.y * view.size.x + at.x)];
  }
  [[nodiscard]] float nearestAt(int level, ivec2 at) const {
    if (refined && level == 0) return pixelAt(twin.nearestOfPixels, at);
    return cellAt(twin.nearest, twin.half(), refined ? level - 1 : level, at);
  }
  [[nodiscard]] vec4 litAt(int level, ivec2 at) const {
    if (refined && level == 0) return nearestAt(0, at) > 0 ? pixelAt(twin.lightOfPixels, at) : vec4(0);
    return cellAt(twin.lit, twin.half(), refined ? level - 1 : level, at);
  }
#include "glsl/draw/exact/reflections/mirrored_way.glsl"

  template <class Cell, class Join>
  static std::vector<Cell> levelsOf(const std::vector<Cell>& full, ivec2 size, const Join& join) {
    const ivec2 room = levelRoom(size);
    std::vector<Cell> cells(static_cast<std::size_t>(room.x) * static_cast<std::size_t>(room.y) / 2 * 3,
                            Cell(0));
    for (int level = 0; level <= lastLevel; ++level)
      for (int y = 0; y < levelSize(size, level).y; ++y)
        for (int x = 0; x < levelSize(size, level).x; ++x) {
          const auto below = [&](int right, int down) {
            return cellAt(cells, size, level - 1, {2 * x + right, 2 * y + down});
          };
          cells[static_cast<std::size_t>(levelPlace(room, level, {x, y}))] =
              level == 0 ? full[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                                static_cast<std::size_t>(x)]
                         : join(level, ivec2(x, y), below(0, 0), below(1, 0), below(0, 1), below(1, 1));
        }
    return cells;
  }
};
#undef EXACT_PICTURE
#undef MIRROR_TWIN
#undef precise
#undef FUNCTION

}  // namespace

void ReflectionsTwin::see(const std::vector<float>& nearness, const std::vector<glm::vec4>& light) {
  nearest = MirrorKernel::levelsOf(nearness, half(), [](int, ivec2, float a, float b, float c, float d) {
    return max(max(a, b), max(c, d));
  });
  const auto lightOf = [&](int x, int y) {
    return light[static_cast<std::size_t>(min(y, view.size.y - 1) * view.size.x + min(x, view.size.x - 1))];
  };
  lightOfPixels = light;
  const auto mean = [](vec4 a, vec4 b, vec4 c, vec4 d) { return 0.25F * ((a + b) + (c + d)); };
  MirrorKernel kernel{*this};
  std::vector<glm::vec4> halves;
  for (int y = 0; y < half().y; ++y)
    for (int x = 0; x < half().x; ++x) {
      const float near = nearness[halves.size()];
      const ivec2 inside = kernel.insideEdge(kernel.nearnessAround({x, y}), near);
      const bool same = kernel.sameObject(kernel.nearestAt(0, ivec2(x, y) + inside), near);
      const ivec2 first = 2 * (same ? ivec2(x, y) + inside : ivec2(x, y));
      halves.push_back(near > 0.0F ? mean(lightOf(first.x, first.y), lightOf(first.x + 1, first.y),
                                          lightOf(first.x, first.y + 1), lightOf(first.x + 1, first.y + 1))
                                   : vec4(0));
    }
  lit = MirrorKernel::levelsOf(halves, half(), [&](int level, ivec2 at, vec4 a, vec4 b, vec4 c, vec4 d) {
    const auto nearAt = [&](int right, int down) {
      return kernel.nearestAt(level - 1, 2 * at + ivec2(right, down));
    };
    return kernel.meanOfNearest({nearAt(0, 0), nearAt(1, 0), nearAt(0, 1), nearAt(1, 1)}, a, b, c, d);
  });
}

glm::vec4 ReflectionsTwin::lightMet(const Ray& ray) const {
  MirrorKernel kernel{*this};
  const MirrorKernel::MirrorWay way =
      kernel.mirrorWay(ray.p, ray.direction, ray.ground, ray.facing, ray.towards, ray.turns, ray.roughness);
  if (way.counts <= 0.0F) return glm::vec4(0);
  return kernel.lightAlong(way, ray.roughness);
}
