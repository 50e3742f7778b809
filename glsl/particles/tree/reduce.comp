// The box around the bodies that take part, by reduction: each invocation makes one pair of corners of 64 bodies
// (the first dispatch, FROM_BODIES) or of 64 pairs. Minima and maxima do not depend on order.
#define REAL float
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(cornersBinding, CornerBlock, corners)
uniform int count;   // of items to reduce
uniform int first;   // pair of the first item, among corners
uniform int result;  // pair of the first result; the results are strided over the items
uniform int results;

vec4 loadBody(int i) {
  return LOAD_INPUT(positions, i);
}
#include "particles/tree/model.glsl"

void main() {
  int mine = int(gl_GlobalInvocationID.x);
  if (mine >= results) return;
  vec3 low = vec3(1e30f);
  vec3 high = vec3(-1e30f);
  for (int i = mine; i < count; i += results) {
#ifdef FROM_BODIES
    vec4 body = loadBody(i);
    bool counts = takesPart(body);
    low = counts ? min(low, body.xyz) : low;
    high = counts ? max(high, body.xyz) : high;
#else
    low = min(low, LOAD_ONCE(corners, 2 * (first + i)).xyz);
    high = max(high, LOAD_ONCE(corners, 2 * (first + i) + 1).xyz);
#endif
  }
  STORE_STATE(corners, 2 * (result + mine), vec4(low, 0.0f));
  STORE_STATE(corners, 2 * (result + mine) + 1, vec4(high, 0.0f));
}
