// Writes a sort record for each body, with its position along the Hilbert curve. Excluded bodies are sorted to the end.
// One invocation per body.
#define REAL float
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
INPUT_ARRAY(cornersBinding, CornerBlock, corners)
STATE_WORDS(recordsBinding, RecordBlock, records)
uniform int count;
uniform int box;  // Index of the corner pair that bounds all bodies

vec4 loadBody(int i) {
  return LOAD_INPUT(positions, i);
}
#include "particles/tree/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec4 body = loadBody(i);
  uvec3 key = uvec3((1u << uint(keyBits)) - 1u);
  if (takesPart(body))
    key = hilbertKey(cellOf(body.xyz, LOAD_INPUT(corners, 2 * box).xyz, LOAD_INPUT(corners, 2 * box + 1).xyz));
  STORE_WORDS(records, i, uvec4(key.x, key.y, uint(i), 0u));
}
