// Writes the sort record of each triangle: the index of the centre of its box along a space-filling curve. BALLS: of
// each ball instead. Missing or invalid items get the last key. One invocation handles one item.
#include "draw/exact/rays/solids.glsl"
#include "draw/exact/rays/grid_block.glsl"
#include "common/words.glsl"
#include "common/space_curve.glsl"
layout(local_size_x = 64) in;
STATE_WORDS(outRecordBinding, RecordBlock, records)
uniform int count;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= count) return;
  Solid solid = solidOf(i);
  uvec3 key = uvec3(0xfffu, 0xffffffu, 0u);
  if (solid.there) {
    precise vec3 middle = solid.low + (solid.high - solid.low) * 0.5f;
    key = hilbertKey(cellOf(middle, lowBound(), highBound()));
    key = uvec3(min(key.x >> 12u, 0xffeu), key.y, 0u);
  }
  STORE_WORDS(records, i, uvec4(key.x, key.y, uint(i), 0u));
}
