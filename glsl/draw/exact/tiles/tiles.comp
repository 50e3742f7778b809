// Adds the ground to the visibility buffer and lists, for each drawn surface, the tiles that show it. One workgroup
// handles one tile; one invocation handles ROWS vertically adjacent pixels. GROUND: two more lists hold the tiles whose
// ground is without shadow, and the other tiles with ground (SHADOW). GROUND_KEYS: also writes the ground's depth keys.
// EMPTIES: also clears the light of all pixels. FEW: there are at most 32 lists including the ground's lists. FOURS:
// there are at most 4 times FOURS lists without the ground's lists. SAMPLES: samples per pixel. PAIRED: as in
// draw/exact/sample_read.glsl.
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
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(binding = firstIdUnit) uniform usamplerBuffer firstIds;
#ifdef PAIRED
layout(std430, binding = nearBinding) writeonly restrict buffer NearBlock { uint words[]; };
#define PUT_ID(at, id) words[2 * (at)] = id
#define PUT_KEY(at, key) words[2 * (at) + 1] = key
#else
#if SAMPLES < 4
layout(std430, binding = idBinding) writeonly restrict buffer IdBlock { uint ids[]; };
#define PUT_ID(at, id) ids[at] = id
#else
// ids of four samples per entry, because software drivers store four values at once
layout(std430, binding = idBinding) writeonly restrict buffer IdBlock { uvec4 ids[]; };
#define PUT_FOUR(at, four) ids[(at) / 4] = four
#endif
layout(std430, binding = nearBinding) writeonly restrict buffer NearBlock { uint nearKeys[]; };
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
#ifdef FOURS
uniform ivec4 firstFour, nextFour;  // first ids of the surfaces (firstIds), padded with values greater than all ids
uvec4 firsts = uvec4(firstFour), next = uvec4(nextFour);  // copies of the first ids, which are thus read once per
                                                          // invocation instead of in each iteration
#endif
#ifdef GROUND
// Nearness of the ground. x: at the centre of the picture's first pixel; y and z: change per pixel to the right and
// downwards; w: max difference within a pixel.
uniform vec4 groundNear;
vec4 groundAffine = groundNear;
// Bounds of rays of depth 1, times the near plane's depth. x: max of |x| and |z| of a ray; y and z: max change of a
// ray's x and z within a pixel.
uniform vec3 groundRays;
vec3 raysAround = groundRays;
#ifdef SHADOW
vec4 shadowReach = texelFetch(light, 4);
#endif
#endif
#ifdef FEW
shared uint shown[1];  // visibility flags: one bit per surface
#else
shared uint shown[64];
#endif

// Surfaces that the invocation's pixels show. With FEW, one atomic adds them at the end, because software drivers
// execute atomics lane by lane.
uint mine = 0u;
void markShown(int draw) {
#ifdef FEW
  mine |= 1u << draw;
#else
  atomicOr(shown[draw >> 5], 1u << (draw & 31));
#endif
}
bool isShown(int draw) {
  return (shown[draw >> 5] >> (draw & 31) & 1u) != 0u;
}

// Number of samples that are read together: 4, or 1 if a pixel has fewer than four samples.
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

#ifdef FOURS
int above(uint id, uvec4 f) {
  return (id >= f.x ? 1 : 0) + (id >= f.y ? 1 : 0) + (id >= f.z ? 1 : 0) + (id >= f.w ? 1 : 0);
}

void showId(uint id) {
  int draw = above(id, firsts) - 1;
#if FOURS > 1
  draw += above(id, next);
#endif
  mine |= id < groundId ? 1u << draw : 0u;
}
#endif

#ifdef GROUND
#ifdef SHADOW
// Returns 2 if a shadow may reach the ground everywhere in the pixel, 1 if no shadow can reach it anywhere in the
// pixel, else 3. For a point p of the ground at depth d, the test uses p / d = eye / d + ray, which is affine in the
// picture position, times the near plane's depth. `middle` is near plane / d at the pixel's centre.
int shadowAround(ivec2 pixel, float middle) {
  precise vec2 place = vec2(pixel) + 0.5f;
  vec3 ray = rayThrough(place);
  vec4 reach = shadowReach;
  vec2 eye = vec2(view.eye.x, view.eye.z), low = vec2(reach.x, reach.y), high = vec2(reach.z, reach.w);
  precise vec2 aside = vec2(ray.x, ray.z) * view.near;
  precise vec2 above = (eye - low) * middle + aside;
  precise vec2 below = (high - eye) * middle - aside;
  precise float wide = groundAffine.w + 1e-5f * abs(middle);
  precise vec2 offAbove = (abs(eye) + abs(low)) * wide + vec2(raysAround.y, raysAround.z);
  precise vec2 offBelow = (abs(eye) + abs(high)) * wide + vec2(raysAround.y, raysAround.z);
  bool within = above.x > offAbove.x && above.y > offAbove.y && below.x > offBelow.x && below.y > offBelow.y;
  bool beside = above.x < -offAbove.x || above.y < -offAbove.y || below.x < -offBelow.x || below.y < -offBelow.y;
  return within ? 2 : beside ? 1 : 3;
}
#endif

// Returns the content that all samples with these keys have, as a value of groundAt(), or 3 if the samples must be
// tested one by one.
int groundOf(ivec2 pixel, uvec4 keys) {
  uint nearest = min(min(keys.x, keys.y), min(keys.z, keys.w)), farthest = max(max(keys.x, keys.y), max(keys.z, keys.w));
  precise float middle = groundAffine.x + groundAffine.y * float(pixel.x) + groundAffine.z * float(pixel.y);
  precise float nearer = middle + groundAffine.w;
  precise float farther = middle - groundAffine.w;
  bool none = nearer <= 0.0f || nearKey(max(nearer, 0.0f)) > farthest;
#ifdef GROUND_KEYS
  int kind = 3;
#elif defined SHADOW
  int kind = shadowAround(pixel, middle);
#else
  int kind = 1;
#endif
  precise vec3 from = view.eye.xyz - frame.target.xyz;
  precise float sure = 0.999f * frame.groundReach - max(abs(from.x), abs(from.z));
  precise float within = sure * farther;
  precise float down = frame.groundHeight - view.eye.y;
  precise float steep = abs(down) * farther;
  precise float minSteep = 3e-6f * view.near;  // same min slope as in groundDepth()
  precise float minNear = view.nearOverFar * 1.001f;
  bool seen = farther >= minNear && steep >= minSteep && nearer <= 0.999f && within >= raysAround.x;
#ifdef PARALLEL
  seen = false;  // The bounds above hold only for perspective views. Here, all samples are tested one by one.
#endif
  bool all_ = seen && nearKey(max(farther, 0.0f)) < nearest;
  return none ? 0 : all_ ? kind : 3;
}

// Returns 0 if the sample does not show the ground, 2 if a shadow may reach the ground there, else 1.
int groundAt(ivec2 pixel, int s, int at, uint key) {
  precise vec2 place = vec2(pixel * 16 + samplePlace(s)) * 0.0625f;
  vec3 ray = rayThrough(place);
  float depth = groundDepth(ray);
  float near = nearOf(depth);
  bool seen = depth >= view.near && near >= view.nearOverFar && nearKey(near) < key;
#ifdef GROUND_KEYS
  if (seen) PUT_KEY(at, nearKey(near));
#endif
#ifdef SHADOW
  vec4 reach = shadowReach;
  vec3 p = placeOnRay(ray, depth);
  bool reached = p.x >= reach.x && p.z >= reach.y && p.x <= reach.z && p.z <= reach.w;
#else
  const bool reached = false;
#endif
  return seen ? reached ? 2 : 1 : 0;
}
#endif

void look(ivec2 pixel) {
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
    int kind = groundOf(pixel, keys);
    bool all_ = kind == 1 || kind == 2;
    four = all_ ? uvec4(groundId) : four;
#ifndef PUT_FOUR
    if (all_)
      for (int k = 0; k < together; ++k) PUT_ID(first + k, groundId);
#endif
    bool changed = all_;
    onGround = max(onGround, all_ ? kind : 0);
    // Tests samples one by one. Uses a loop that ends at once if no test is needed, because software drivers execute
    // both sides of a branch.
    int left_ = kind == 3 ? (1 << together) - 1 : 0;
    while (left_ != 0) {
      int i = findLSB(left_);
      left_ &= left_ - 1;
      uint key = keys.x;
      for (int k = 1; k < together; ++k) key = k == i ? keys[k] : key;
      int found = groundAt(pixel, s + i, first + i, key);
      for (int k = 0; k < together; ++k) four[k] = found > 0 && k == i ? groundId : four[k];
#ifndef PUT_FOUR
      if (found > 0) PUT_ID(first + i, groundId);
#endif
      changed = changed || found > 0;
      onGround = max(onGround, found);
    }
#ifdef PUT_FOUR
    if (changed) PUT_FOUR(first, four);
#endif
#endif
    for (int i = 0; i < together; ++i) {
      seen[s + i] = four[i];
      left |= four[i] < groundId ? 1 << (s + i) : 0;
    }
  }
#ifdef FOURS
  for (int s = 0; s < SAMPLES; ++s) showId(seen[s]);
#else
  while (left != 0) {  // one iteration for each surface that the pixel shows
    uint id = emptyId;
    for (int s = SAMPLES - 1; s >= 0; --s) id = (left >> s & 1) != 0 ? seen[s] : id;
    left &= left - 1;
    int draw = drawOf(id);
    markShown(draw);
    uint from = texelFetch(firstIds, draw).x, to = draw + 1 < draws ? texelFetch(firstIds, draw + 1).x : groundId;
    for (int s = 0; s < SAMPLES; ++s) left &= seen[s] >= from && seen[s] < to ? ~(1 << s) : ~0;
  }
#endif
  if (onGround > 0) markShown(draws + onGround - 1);
}

void main() {
  const int lanes = tileSide * tileSide / ROWS;
  int me = int(gl_LocalInvocationIndex);
  for (int i = me; i < shown.length(); i += lanes) shown[i] = 0u;
  barrier();
  ivec2 at = ivec2(gl_WorkGroupID.xy) + ivec2(0, firstTileRow);
  ivec2 pixel = at * tileSide + ivec2(gl_LocalInvocationID.xy) * ivec2(1, ROWS) + ivec2(0, view.rows.x);
  for (int row = 0; row < ROWS; ++row) {
    ivec2 next = pixel + ivec2(0, row);
    if (next.x < view.size.x && next.y < view.rows.y) look(next);
  }
#ifdef FEW
  if (mine != 0u) atomicOr(shown[0], mine);
#endif
  barrier();
  uint tile = uint(at.x) | uint(at.y) << 16;
  for (int draw = me; draw < draws + 2; draw += lanes) {
    bool listed = isShown(draw);
    if (draw == draws && isShown(draws + 1)) listed = false;
    if (listed) lists[draw * tileCount + int(atomicAdd(counters[draw], 1u))] = tile;
  }
}
