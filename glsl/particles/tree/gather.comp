// Writes the bodies in sorted order. Entries for excluded bodies and entries beyond the last body are zero. One
// invocation per entry.
#define REAL float
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "particles/tree/bindings.glsl"
#include "particles/tree/types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(bodiesBinding, BodyBlock, bodies)
INPUT_WORDS(recordsBinding, RecordBlock, records)
uniform int count;
uniform int padded;  // Number of entries, rounded up to whole trees

vec4 loadBody(int i) {
  return LOAD_INPUT(positions, i);
}
#include "particles/tree/model.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= padded) return;
  vec4 body = vec4(0.0f);
  if (i < count) body = loadBody(int(LOAD_INPUT_WORDS(records, i).z));
  STORE_STATE(bodies, i, takesPart(body) ? body : vec4(0.0f));
}
