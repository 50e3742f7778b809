// The samples of a volume: its cells, with `ring` 1 a layer around them that is outside, so that the surface is closed.
// Words of 32 samples along x, a bit each: word = (z height + y) rowElements + x / 32. An invocation has a word.
#include "common/words.glsl"
#include "common/exact.glsl"
#include "volume/bindings.glsl"
uniform ivec4 volume;      // cells along x, y and z; w: ring
uniform int rowElements;   // words of a row of samples

int ringWidth() {
  return volume.w;
}
ivec3 samplesOf() {
  return volume.xyz + 2 * volume.w;
}
// x: number of the word's first sample along x, y and z; w: the word's number, -1: there is no such word.
ivec4 wordPlace(ivec2 invocation) {
  ivec3 samples = samplesOf();
  int y = invocation.x / rowElements, x = invocation.x - y * rowElements, z = invocation.y;
  bool there = y < samples.y && z < samples.z;
  return ivec4(32 * x, y, z, there ? (z * samples.y + y) * rowElements + x : -1);
}
