// Computes one level of the mip pyramid that reflections read (levels.glsl) from the previous level. Light and coverage
// are the mean of the four cells without objects behind the nearest one (edges.glsl), nearness is their max; both are 0
// for empty cells. FIRST: computes level 0 from the light
// of the pixels and the nearness of the occlusion pass. Half pixels at the edge of an object have the light of a
// neighbour inside the object (edges.glsl). GROUND: removes the ground, which mirrored_ground.glsl handles.
// One invocation writes ROWS vertically adjacent cells.
#define EXACT_PICTURE
#include "common/once.glsl"
#include "common/exact.glsl"
#include "draw/exact/bindings.glsl"
#include "draw/exact/reflections/levels.glsl"
#include "draw/exact/reflections/edges.glsl"
#ifdef GROUND
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/occlusion/ground_nearness.glsl"
#endif
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(r32f, binding = nearnessImage) readonly restrict uniform imageBuffer nearestBefore;
#ifdef FIRST
layout(rgba32f, binding = sumImage) readonly restrict uniform image2D sums;
#else
layout(rgba32f, binding = litImage) readonly restrict uniform imageBuffer litBefore;
#endif
layout(std430, binding = litBinding) writeonly restrict buffer LitBlock { vec4 lit[]; };
layout(std430, binding = halfPixelBinding) writeonly restrict buffer NearestBlock { float nearest[]; };
uniform ivec2 size;  // picture size in pixels
uniform int level;
ivec2 half_ = (size + 1) / 2, room = levelRoom(half_), end = levelSize(half_, level), last = levelSize(half_, level - 1) - 1;

// Returns the light of a cell of the previous level, or zero beyond the border.
vec4 lightBefore(ivec2 at) {
#ifdef FIRST
  return imageLoad(sums, min(at, size - 1));
#else
  vec4 found = imageLoad(litBefore, levelPlace(room, level - 1, min(at, last)));
  return at.x <= last.x && at.y <= last.y ? found : vec4(0.0f);
#endif
}

#ifdef FIRST
// Returns the nearness of the objects in a half pixel, or 0 beyond the border.
float objectNear(ivec2 at) {
  ivec2 held = clamp(at, ivec2(0), half_ - 1);
  float near = imageLoad(nearestBefore, held.y * half_.x + held.x).x;
#ifdef GROUND
  near = near == nearnessPerMetre(groundNearness(held)) ? 0.0f : near;
#endif
  return held == at ? near : 0.0f;
}
#endif

float nearBefore(ivec2 at) {
  float found = imageLoad(nearestBefore, levelPlace(room, level - 1, min(at, last))).x;
  return at.x <= last.x && at.y <= last.y ? found : 0.0f;
}

void main() {
  ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 at = first + ivec2(0, row);
    if (at.x >= end.x || at.y >= end.y) continue;
    ivec2 a = 2 * at, b = a + ivec2(1, 0), c = a + ivec2(0, 1), d = a + 1;
    int place = levelPlace(room, level, at);
#ifdef FIRST
    float near = objectNear(at);
#else
    vec4 nears = vec4(nearBefore(a), nearBefore(b), nearBefore(c), nearBefore(d));
    float near = max(max(nears.x, nears.y), max(nears.z, nears.w));
#endif
    nearest[place] = near;
    precise vec4 mean = vec4(0.0f);
    IF_ANY(near > 0.0f) {
#ifdef FIRST
      ivec2 inside = insideEdge(vec4(objectNear(at - ivec2(1, 0)), objectNear(at + ivec2(1, 0)), objectNear(at - ivec2(0, 1)),
                                     objectNear(at + ivec2(0, 1))), near);
      if (inside != ivec2(0) && sameObject(objectNear(at + inside), near)) {
        a += 2 * inside;
        b += 2 * inside;
        c += 2 * inside;
        d += 2 * inside;
      }
      mean = 0.25f * ((lightBefore(a) + lightBefore(b)) + (lightBefore(c) + lightBefore(d)));
#else
      mean = meanOfNearest(nears, lightBefore(a), lightBefore(b), lightBefore(c), lightBefore(d));
#endif
    }
    lit[place] = mean;
  }
}
