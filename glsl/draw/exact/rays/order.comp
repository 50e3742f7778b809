// Writes the triangles in the order of the sorted records, with their boxes. BALLS: writes the balls instead. One
// invocation writes one item.
// A triangle has the corners a, b and c, each with one word of the box. In the first word, bit 31 means that the
// triangle casts no shadow, and bit 15 that it may let rays through.
// A ball has centre and radius, then the box and the ball's index. Bit 31 of the first box word means that the ball
// casts no shadow.
#include "draw/exact/rays/solids.glsl"
#include "draw/exact/rays/grid_block.glsl"
#include "common/words.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(recordUnit, RecordBlock, records)
layout(std430, binding = outRecordBinding) writeonly restrict buffer SortedBlock { uvec4 sorted[]; };
#ifndef BALLS
layout(binding = solidWordUnit) uniform usamplerBuffer vertexWords;
layout(std430, binding = outIdBinding) writeonly restrict buffer IdBlock { uint ids[]; };
#endif
#include "draw/exact/rays/looks.glsl"
#ifdef BALLS
layout(binding = ballLookUnit) uniform samplerBuffer ballLooks;
#endif
uniform int count;

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= count) return;
  int number = int(LOAD_INPUT_WORDS(records, i).z);
  Solid solid = solidOf(number);
  uvec3 box = solid.there ? packedBox(gridOfAll(), solid.low, solid.high) : uvec3(emptyBoxX, emptyBoxY, emptyBoxZ);
#ifdef BALLS
  bool casts = lookOf(int(texelFetch(ballLooks, number).w), fallbackMaterial).w > 0.0f;
  sorted[2 * i] = floatBitsToUint(solid.there ? solid.ball : vec4(0));
  sorted[2 * i + 1] = uvec4(box.x | (casts ? 0u : 0x80000000u), box.yz, uint(number));
#else
  int owner = int(texelFetch(vertexWords, int(texelFetch(corners, 3 * number).x)).w);
  bool casts = lookOf(owner, fallbackMaterial).w > 0.0f;
  uint marks = (casts ? 0u : 0x80000000u) | (letsThrough(owner) ? 0x8000u : 0u);
  sorted[3 * i] = uvec4(floatBitsToUint(solid.there ? solid.a.xyz : vec3(0)), box.x | marks);
  sorted[3 * i + 1] = uvec4(floatBitsToUint(solid.there ? solid.b.xyz : vec3(0)), box.y);
  sorted[3 * i + 2] = uvec4(floatBitsToUint(solid.there ? solid.c.xyz : vec3(0)), box.z);
  ids[i] = uint(number);
#endif
}
