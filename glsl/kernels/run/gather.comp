// Copies up to four numbers of each element of a user's buffer into a vec4 array for drawing. One invocation
// per element.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer WordsBlock { uint words[]; };
STATE_ARRAY(1, DrawnBlock, drawn)
uniform int count;     // number of elements
uniform int start;     // word offset of the first element
uniform int stride;    // number of words per element
uniform ivec4 places;  // word offsets of the four numbers within an element; -1 for the value of `fill`
uniform vec4 fill;
uniform int number;    // type of the numbers: 0 float, 1 int, 2 uint
uniform int alive;     // word offset of a number that is above 0 in drawn elements; -1 if all elements are drawn
uniform int aliveNumber;
uniform bool encoded;  // true if the first three numbers are sRGB values, which are converted to linear values

float numberAt(int word, int type) {
  uint bits = words[word];
  return type == 0 ? uintBitsToFloat(bits) : type == 1 ? float(int(bits)) : float(bits);
}

// Converts an sRGB value to a linear value (IEC 61966-2-1).
float linearOf(float x) {
  precise float low = x * 0.0773993808;
  precise float base = (x + 0.055) * 0.947867299;
  return x <= 0.04045 ? low : exactPow(base, 2.4);
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  int element = start + i * stride;
  vec4 result = fill;
  for (int c = 0; c < 4; ++c)
    if (places[c] >= 0) result[c] = numberAt(element + places[c], number);
  if (encoded)
    for (int c = 0; c < 3; ++c) result[c] = linearOf(clamp(result[c], 0.0, 1.0));
  if (alive >= 0 && !(numberAt(element + alive, aliveNumber) > 0.0)) result.w = -1.0;
  STORE_STATE(drawn, i, result);
}
