// Finds the uneven half pixels: those whose change of light by reflections differs visibly from a neighbour's. These
// are at outlines of reflected objects. One invocation handles a tile (4x4 half pixels) and writes the mask of its
// uneven half pixels. CLEAR: sets the changes of the pixels of uneven half pixels to zero, so that kernels with
// REFLECTED can compute them again for each pixel (refined.glsl).
#include "draw/frame_block.glsl"
#include "draw/exact/bindings.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
uniform ivec2 size;  // picture size in pixels
#ifdef CLEAR
layout(rgba32f, binding = lightImage) writeonly restrict uniform image2D cleared;
layout(r32ui, binding = unevenImage) readonly restrict uniform uimageBuffer unevenTiles;

void clearTile(ivec2 tile, int place) {
  int uneven = int(imageLoad(unevenTiles, place).x);
  while (uneven != 0) {
    int i = findLSB(uneven);
    uneven &= uneven - 1;
    for (int k = 0; k < 4; ++k)
      imageStore(cleared, 8 * tile + 2 * ivec2(i & 3, i >> 2) + ivec2(k & 1, k >> 1), vec4(0.0f));
  }
}
#else
layout(rgba32f, binding = lightImage) readonly restrict uniform image2D changes;
layout(rgba32f, binding = sumImage) readonly restrict uniform image2D sums;
layout(std430, binding = unevenBinding) writeonly restrict buffer UnevenBlock { uint uneven[]; };
const float leastPart = 0.03f;     // min visible difference, relative to the light
const float leastLight = 0.0015f;  // min visible difference, relative to white

// Returns the change in the first pixel of a half pixel. Half pixels beyond the border are those at the border.
vec3 changeAt(ivec2 at) {
  return imageLoad(changes, 2 * clamp(at, ivec2(0), (size - 1) / 2)).rgb;
}

float maxOf(vec3 light) {
  return max(light.r, max(light.g, light.b));
}

// Returns true if the changes a and b of neighbouring half pixels differ visibly. `at` is one of them.
bool differ(vec3 a, vec3 b, ivec2 at) {
  precise vec3 difference = a - b;
  precise float off = maxOf(abs(difference)) * frame.exposure;
  float least = leastLight;
  IF_ANY(off > leastLight) {
    vec3 before = imageLoad(sums, 2 * clamp(at, ivec2(0), (size - 1) / 2)).rgb;
    precise vec3 light = before + max(a, b);
    precise float part = leastLight + leastPart * maxOf(light) * frame.exposure;
    least = part;
  }
  return off > least;
}

uint unevenIn(ivec2 tile) {
  ivec2 first = 4 * tile;
  vec3 above[4];
  uint mask = 0u;
  for (int x = 0; x < 4; ++x) above[x] = changeAt(first + ivec2(x, -1));
  for (int y = 0; y < 5; ++y) {
    ivec2 at = first + ivec2(0, y);
    vec3 before = y < 4 ? changeAt(at - ivec2(1, 0)) : vec3(0.0f);
    for (int x = 0; x < 4; ++x) {
      vec3 here = changeAt(at + ivec2(x, 0));
      uint own = y < 4 ? 1u << (4 * y + x) : 0u;
      if (differ(here, above[x], at + ivec2(x, 0))) mask |= own | (y > 0 ? 1u << (4 * y + x - 4) : 0u);
      if (y < 4 && differ(here, before, at + ivec2(x, 0))) mask |= own | (x > 0 ? own >> 1 : 0u);
      above[x] = here;
      before = here;
    }
    vec3 right = y < 4 ? changeAt(at + ivec2(4, 0)) : before;
    if (y < 4 && differ(before, right, at + ivec2(3, 0))) mask |= 1u << (4 * y + 3);
  }
  return mask;
}
#endif

void main() {
  ivec2 tiles = (size + 7) / 8, first = ivec2(gl_GlobalInvocationID.xy) * ivec2(1, ROWS);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 tile = first + ivec2(0, row);
    if (tile.x >= tiles.x || tile.y >= tiles.y) continue;
    int place = tile.y * tiles.x + tile.x;
#ifdef CLEAR
    clearTile(tile, place);
#else
    uneven[place] = unevenIn(tile);
#endif
  }
}
