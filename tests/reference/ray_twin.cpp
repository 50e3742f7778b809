#include "reference/ray_twin.hpp"

#include "draw/picture_code.hpp"

#include <bit>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/draw/exact/rays/ray_shapes.glsl"
#include "glsl/draw/exact/rays/walk.glsl"
}  // namespace simreel::shader
#undef precise
#undef FUNCTION

namespace {

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names

vec4 asFloats(const uvec4& words) {
  return {std::bit_cast<float>(words.x), std::bit_cast<float>(words.y), std::bit_cast<float>(words.z),
          std::bit_cast<float>(words.w)};
}

RayTwin::Hit asHit(const RayHit& hit) {
  return {hit.t, hit.at, hit.weight};
}

constexpr int ballBit = 0x40000000;

/// The data that the kernel reads.
struct Walk {
  std::span<const uvec4> nodes, sorted;
  RayHit test(const Ray& ray, const RayPlanes& planes, const RayHit& best, int i) const {
    const auto at = 3 * static_cast<std::size_t>(i);
    const uvec4 &a = sorted[at], &b = sorted[at + 1], &c = sorted[at + 2];
    return nearerTriangle(ray, vec3(asFloats(a)), vec3(asFloats(b)), vec3(asFloats(c)),
                          spanIn(planes, a.w, b.w, c.w), i, best);
  }
#define texelFetch(texels, i) (texels)[static_cast<std::size_t>(i)]
#define WALK_OVER(best) false
  WALK(walk, nodes, test)
#undef WALK_OVER
#undef texelFetch
};

}  // namespace

RayTwin::Hit RayTwin::nearestTriangle(glm::vec3 origin, glm::vec3 along, float far) const {
  const Ray ray = rayOf(origin, along);
  const RayPlanes planes = rayPlanes(rayGrid(low, high), origin, along);
  RayHit best{far, -1, vec2(0)};
  for (std::size_t i = 0; i < sorted.size(); i += 3) {
    const uvec4 &a = sorted[i], &b = sorted[i + 1], &c = sorted[i + 2];
    best = nearerTriangle(ray, vec3(asFloats(a)), vec3(asFloats(b)), vec3(asFloats(c)),
                          spanIn(planes, a.w, b.w, c.w), static_cast<int>(i / 3), best);
  }
  return asHit(best);
}

RayTwin::Hit RayTwin::nearestBall(glm::vec3 origin, glm::vec3 along, float far) const {
  const Ray ray = rayOf(origin, along);
  const RayPlanes planes = rayPlanes(rayGrid(low, high), origin, along);
  RayHit best{far, -1, vec2(0)};
  for (std::size_t i = 0; i < sorted.size(); i += 2) {
    const vec4 ball = asFloats(sorted[i]);
    const uvec4& box = sorted[i + 1];
    best = nearerBall(ray, vec3(ball), ball.w, spanIn(planes, box.x, box.y, box.z),
                      static_cast<int>(i / 2) | ballBit, best);
  }
  return asHit(best);
}

RayTwin::Hit RayTwin::walked(std::span<const glm::uvec4> nodes, int leaves, glm::vec3 origin,
                             glm::vec3 along, float far) const {
  Walk walk{nodes, sorted};
  const Ray ray = rayOf(origin, along);
  return asHit(walk.walk(ray, rayPlanes(rayGrid(low, high), origin, along), RayHit{far, -1, vec2(0)},
                         static_cast<int>(sorted.size() / 3), leaves));
}

glm::uvec3 RayTwin::boxOf(glm::vec3 from, glm::vec3 to) const {
  return packedBox(rayGrid(low, high), from, to);
}
