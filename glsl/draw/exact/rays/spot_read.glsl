// Reads spots and their paths. The kernel handles the spots of a list from index `firstSpot` on, and for each spot the
// samples from index `firstRaySample` on.
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/unit_vector.glsl"
#include "common/hash.glsl"
#include "draw/exact/rays/sequence.glsl"
layout(binding = spotUnit) uniform usamplerBuffer spots;
layout(binding = spotListUnit) uniform usamplerBuffer spotList;
uniform int firstSpot;
uniform int spotCount;
uniform int firstRaySample;
uniform uint sampleMask;
uniform uint samplesBefore;  // number of samples that earlier lens points have used

struct PathStart {
  int at;       // index of the spot where the path starts
  uint number;  // index of the path's sample
  uint seed;
  bool there;
};
PathStart pathStart(int path) {
  uvec2 entry = texelFetch(spotList, firstSpot + path % spotCount).xy;
  int number = firstRaySample + path / spotCount;
  int at = int(entry.x), pixel = at / SAMPLES;
  int y = pixel / view.size.x;
  uvec3 mixed = hash3(uvec3(uint(pixel - y * view.size.x), uint(y + view.rows.x), uint(at - pixel * SAMPLES)));
  return PathStart(at, uint(number) + samplesBefore, mixed.x, number < int(entry.y));
}
