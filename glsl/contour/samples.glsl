// Samples of a contour's field: the field with a ring of one sample around it, so that every contour is closed. Rows
// run from left to right, with sixteen classes per element. Each row is padded to whole elements with the class
// `outside`.
#include "contour/bindings.glsl"
#include "common/exact.glsl"
#include "contour/model.glsl"
uniform ivec2 samples;     // Size of the field plus 2
uniform int rowElements;
uniform int outside;       // Class of the samples in the ring

int elementCount() {
  return rowElements * samples.y;
}
uint byteOf(uvec4 four, int i) {
  uint word = i < 8 ? (i < 4 ? four.x : four.y) : (i < 12 ? four.z : four.w);
  return word >> uint(8 * (i & 3)) & 255u;
}
