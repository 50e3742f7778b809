// All-pairs gravity, O(N^2): computes the pull of a range of bodies on a range of targets. Bodies are summed in order,
// with a separate sum for each chunk of chunkBodies. Therefore, both memory paths, every division into dispatches, and
// the CPU twin give the same bits.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "particles/bindings.glsl"
#include "particles/types.glsl"
#include "particles/pairs.glsl"

INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(accelerationsBinding, AccelerationBlock, accelerations)
uniform ivec2 targets;  // Index of the first target, and index past the last
uniform ivec2 bodies;   // Index of the first body (a multiple of chunkBodies), and index past the last
uniform float softeningSquared;  // Squared softening length in m^2
uniform float gravity;           // Gravitational constant G, m^3/(kg s^2)
uniform bool continued;  // True if `accelerations` holds the partial sums of earlier dispatches
uniform bool last;       // True in the last dispatch, where the sum is multiplied by G

void finish(int i, vec3 sum) {
  precise vec3 scaled = sum * gravity;
  STORE_STATE(accelerations, i, vec4(last ? scaled : sum, 0.0f));
}

vec3 begin(int i) {
  return continued ? LOAD_STATE(accelerations, i).xyz : vec3(0.0f);
}

// Each round of the loop processes four bodies, to reduce the loop overhead. The storage path, which has more
// registers, processes eight.
#define PULL(k)                                        \
  sum##k = addPull(sum##k, here##k, body0, softeningSquared); \
  sum##k = addPull(sum##k, here##k, body1, softeningSquared); \
  sum##k = addPull(sum##k, here##k, body2, softeningSquared); \
  sum##k = addPull(sum##k, here##k, body3, softeningSquared);

#ifdef TEXEL_PATH
// On software drivers, a texel load is expensive compared with the arithmetic, so an invocation uses each load for
// eight targets. An invocation is one SIMD lane.
layout(local_size_x = 16) in;
#define EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)

void main() {
  int first = targets.x + int(gl_GlobalInvocationID.x) * 8;
  if (first >= targets.y) return;
#define START(k)                                                     \
  int i##k = min(first + k, targets.y - 1);                          \
  vec3 here##k = LOAD_INPUT(positions, i##k).xyz;                    \
  precise vec3 total##k = begin(i##k);
  EACH(START)
  for (int chunk = bodies.x; chunk < bodies.y; chunk += chunkBodies) {
#define ZERO(k) vec3 sum##k = vec3(0.0f);
    EACH(ZERO)
    int end = min(chunk + chunkBodies, bodies.y);
    int j = chunk;
    for (; j + 4 <= end; j += 4) {
      vec4 body0 = LOAD_INPUT(positions, j);
      vec4 body1 = LOAD_INPUT(positions, j + 1);
      vec4 body2 = LOAD_INPUT(positions, j + 2);
      vec4 body3 = LOAD_INPUT(positions, j + 3);
      EACH(PULL)
    }
    for (; j < end; ++j) {
      vec4 body = LOAD_INPUT(positions, j);
#define PULL_ONE(k) sum##k = addPull(sum##k, here##k, body, softeningSquared);
      EACH(PULL_ONE)
    }
#define JOIN(k) total##k = total##k + sum##k;
    EACH(JOIN)
  }
#define FINISH(k) finish(i##k, total##k);
  EACH(FINISH)
}
#else
// An invocation uses each load from shared memory for all its targets. If there are few targets in total, TARGETS is 1,
// because otherwise most of the GPU would be idle.
layout(local_size_x = 256) in;
#if TARGETS == 4
#define EACH(DO) DO(0) DO(1) DO(2) DO(3)
#else
#define EACH(DO) DO(0)
#endif
shared vec4 tile[256];

void main() {
  int lane = int(gl_LocalInvocationID.x);
  int first = targets.x + int(gl_WorkGroupID.x) * 256 * TARGETS + lane;
#define START(k)                                      \
  int i##k = min(first + k * 256, targets.y - 1);     \
  vec3 here##k = LOAD_INPUT(positions, i##k).xyz;     \
  precise vec3 total##k = begin(i##k);
  EACH(START)
  for (int chunk = bodies.x; chunk < bodies.y; chunk += chunkBodies) {
#define ZERO(k) vec3 sum##k = vec3(0.0f);
    EACH(ZERO)
    int end = min(chunk + chunkBodies, bodies.y);
    for (int start = chunk; start < end; start += 256) {
      // Beyond the end, massless bodies are used. Their pull of zero changes no bit of the sum.
      tile[lane] = start + lane < end ? LOAD_INPUT(positions, start + lane) : vec4(0.0f);
      barrier();
      for (int j = 0; j < 256; j += 8) {
        vec4 body0 = tile[j];
        vec4 body1 = tile[j + 1];
        vec4 body2 = tile[j + 2];
        vec4 body3 = tile[j + 3];
        EACH(PULL)
        body0 = tile[j + 4];
        body1 = tile[j + 5];
        body2 = tile[j + 6];
        body3 = tile[j + 7];
        EACH(PULL)
      }
      barrier();
    }
#define JOIN(k) total##k = total##k + sum##k;
    EACH(JOIN)
  }
  // A target index beyond the end repeats the last target. Only the invocation with the index of that target stores its
  // result.
#define FINISH(k) \
  if (first + k * 256 < targets.y) finish(i##k, total##k);
  EACH(FINISH)
}
#endif
