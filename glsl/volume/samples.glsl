// Samples of a volume: its cells, with `ring` 1 surrounded by a layer of outside samples, so that the surface is
// closed. A word holds a bit for each of 32 samples along x: word = (z height + y) rowElements + x / 32. One word per
// invocation.
#include "common/words.glsl"
#include "common/exact.glsl"
#include "volume/bindings.glsl"
uniform ivec4 volume;      // Number of cells along x, y and z; w: ring
uniform int rowElements;   // Words per row of samples

int ringWidth() {
  return volume.w;
}
ivec3 samplesOf() {
  return volume.xyz + 2 * volume.w;
}
// Returns the position of the word's first sample (xyz) and the word's index (w), or -1 if there is no such word.
ivec4 wordPlace(ivec2 invocation) {
  ivec3 samples = samplesOf();
  int y = invocation.x / rowElements, x = invocation.x - y * rowElements, z = invocation.y;
  bool there = y < samples.y && z < samples.z;
  return ivec4(32 * x, y, z, there ? (z * samples.y + y) * rowElements + x : -1);
}
