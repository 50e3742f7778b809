// Computes the bounding box of all bodies that take part, by reduction. An invocation reduces 64 bodies (first
// dispatch, with FROM_BODIES) or 64 corner pairs to one corner pair. Minimum and maximum do not depend on the order.
#define REAL float
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(cornersBinding, CornerBlock, corners)
uniform int count;   // Number of items to reduce
uniform int first;   // Index of the first item's corner pair
uniform int result;  // Index of the first result's corner pair; result r reduces the items r, r + results, ...
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
