// Samples of a volume: its cells and, if `ring` is 1, a surrounding layer of outside samples, so that the surface is
// closed. A word holds one bit for each of 32 samples along x; its index is (z height + y) rowElements + x / 32. One
// invocation per word.
#include "common/words.glsl"
#include "common/exact.glsl"
#include "volume/bindings.glsl"
uniform ivec4 volume;      // Number of cells along x, y and z; w is `ring`
uniform int rowElements;   // Number of words per row of samples

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
