// The samples: the field with a ring of one around it, so that every contour is closed; rows from left to right, sixteen
// classes an element, each row filled up to whole elements by the class outside.
#include "contour/bindings.glsl"
#include "common/exact.glsl"
#include "contour/model.glsl"
uniform ivec2 samples;     // the field's size + 2
uniform int rowElements;
uniform int outside;       // class of the ring

int elementCount() {
  return rowElements * samples.y;
}
uint byteOf(uvec4 four, int i) {
  uint word = i < 8 ? (i < 4 ? four.x : four.y) : (i < 12 ? four.z : four.w);
  return word >> uint(8 * (i & 3)) & 255u;
}
