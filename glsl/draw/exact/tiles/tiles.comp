// Lays the ground under what is visible and lists, for each thing drawn, the tiles that show it: a group does one. With
// GROUND two lists more, of tiles whose ground no shadow can reach, and of the others (SHADOW). GROUND_KEYS: what is nearest has the
// ground, too. EMPTIES: the light of all pixels, too. FEW: lists for 32 at most, the
// ground's included. SAMPLES, PAIRED.
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/tiles/tile_lists.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/triangles/triangle.glsl"
#ifdef GROUND
#include "draw/exact/ground_plane.glsl"
#endif
#ifdef SHADOW
#include "draw/exact/light_place.glsl"
#endif
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = firstIdUnit) uniform usamplerBuffer firstIds;
#ifdef PAIRED
layout(std430, binding = nearBinding) writeonly restrict buffer PairBlock { uint words[]; };
#define PUT_ID(at, id) words[2 * (at)] = id
#define PUT_KEY(at, key) words[2 * (at) + 1] = key
#else
layout(std430, binding = idBinding) writeonly restrict buffer IdBlock { uint ids[]; };
layout(std430, binding = nearBinding) writeonly restrict buffer NearBlock { uint nearKeys[]; };
#define PUT_ID(at, id) ids[at] = id
#define PUT_KEY(at, key) nearKeys[at] = key
#endif
#ifdef EMPTIES
layout(rgba32f, binding = sumImage) writeonly restrict uniform image2D sums;
#endif
layout(std430, binding = counterBinding) restrict buffer CounterBlock { uint counters[]; };
layout(std430, binding = tileListBinding) writeonly restrict buffer ListBlock { uint lists[]; };
uniform int draws;
uniform int tileCount;
uniform int firstTileRow;
shared uint shown[64];  // a bit a thing, and a word an invocation; FEW: those of the first alone

// What an invocation shows; with FEW all of it together, since software drivers do atomics lane by lane.
uint mine = 0u;
void show(int draw) {
#ifdef FEW
  mine |= 1u << draw;
#else
  atomicOr(shown[draw >> 5], 1u << (draw & 31));
#endif
}
bool isShown(int draw) {
  return (shown[draw >> 5] >> (draw & 31) & 1u) != 0u;
}

// Samples s to s + 3, or s alone, of what lies at `at`.
#if SAMPLES < 4
const int together = 1;
#define FETCHED(ALONE, FOURS, AT) uvec4(ALONE(AT))
#else
const int together = 4;
#define FETCHED(ALONE, FOURS, AT) FOURS(AT)
#endif

int drawOf(uint id) {
  int low = 0, high = draws;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (texelFetch(firstIds, middle).x <= id) low = middle;
    else high = middle;
  }
  return low;
}

#ifdef GROUND
// 1 where the ground is what the sample shows, 2 where a shadow may reach it.
int groundAt(ivec2 pixel, int s, int at, uint key) {
  precise vec2 place = vec2(pixel * 16 + samplePlace(s)) * 0.0625f;
  vec3 ray = rayThrough(place);
  float depth = groundDepth(ray);
  float perDepth = exactReciprocal(max(depth, 1e-6f));
  precise float near = view.near * perDepth;
  bool seen = depth >= view.near && near >= view.nearOverFar && nearKey(near) < key;
#ifdef GROUND_KEYS
  if (seen) PUT_KEY(at, nearKey(near));
#endif
#ifdef SHADOW
  vec4 reach = texelFetch(light, 4);
  vec3 p = placeOnRay(ray, depth);
  bool reached = p.x >= reach.x && p.z >= reach.y && p.x <= reach.z && p.z <= reach.w;
#else
  const bool reached = false;
#endif
  return seen ? reached ? 2 : 1 : 0;
}
#endif

void main() {
  int me = int(gl_LocalInvocationIndex);
  shown[me] = 0u;
  barrier();
  ivec2 at = ivec2(gl_WorkGroupID.xy) + ivec2(0, firstTileRow);
  ivec2 pixel = at * tileSide + ivec2(gl_LocalInvocationID.xy) + ivec2(0, view.rows.x);
  bool within = pixel.x < view.size.x && pixel.y < view.rows.y;
  if (within) {
#ifdef EMPTIES
    imageStore(sums, pixel, vec4(0.0f));
#endif
    int onGround = 0, left = 0;
    uint seen[SAMPLES];
    for (int s = 0; s < SAMPLES; s += together) {
      int first = firstSample(pixel) + s;
      uvec4 four = FETCHED(idAt, fourIdsAt, first);
#ifdef GROUND
      uvec4 keys = FETCHED(keyAt, fourKeysAt, first);
#endif
      for (int i = 0; i < together; ++i) {
        seen[s + i] = four[i];
#ifdef GROUND
        int kind = groundAt(pixel, s + i, first + i, keys[i]);
        if (kind > 0) {
          seen[s + i] = groundId;
          PUT_ID(first + i, groundId);
          onGround = max(onGround, kind);
        }
#endif
        left |= seen[s + i] < groundId ? 1 << (s + i) : 0;
      }
    }
    while (left != 0) {  // once for each thing of the pixel
      uint id = emptyId;
      for (int s = SAMPLES - 1; s >= 0; --s) id = (left >> s & 1) != 0 ? seen[s] : id;
      left &= left - 1;
      int draw = drawOf(id);
      show(draw);
      uint from = texelFetch(firstIds, draw).x, to = draw + 1 < draws ? texelFetch(firstIds, draw + 1).x : groundId;
      for (int s = 0; s < SAMPLES; ++s) left &= seen[s] >= from && seen[s] < to ? ~(1 << s) : ~0;
    }
    if (onGround > 0) show(draws + onGround - 1);
#ifdef FEW
    if (mine != 0u) atomicOr(shown[0], mine);
#endif
  }
  barrier();
  uint tile = uint(at.x) | uint(at.y) << 16;
  for (int draw = me; draw < draws + 2; draw += tileSide * tileSide) {
    bool listed = isShown(draw);
    if (draw == draws && isShown(draws + 1)) listed = false;
    if (listed) lists[draw * tileCount + int(atomicAdd(counters[draw], 1u))] = tile;
  }
}
