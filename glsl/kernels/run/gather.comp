// Copies up to four numbers of each element of a user's buffer into a vec4 array for drawing. Each
// invocation takes every `threads`-th element.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer WordsBlock { uint words[]; };
STATE_ARRAY(1, DrawnBlock, drawn)
layout(std430, binding = 2) buffer NotedBlock { uvec4 noted[]; };  // x: number of elements that are not finite; y:
                                                                   // index of the first of them
uniform int count;     // number of elements
uniform int threads;   // number of invocations
uniform int start;     // word offset of the first element
uniform int stride;    // number of words per element
uniform ivec4 places;  // word offsets of the four numbers within an element; -1 for the value of `fill`
uniform vec4 fill;
uniform int number;    // type of the numbers: 0 float, 1 int, 2 uint
uniform int alive;     // word offset of a number that is above 0 in drawn elements; -1 if all elements are drawn
uniform int aliveNumber;
uniform bool marked;    // true if w of elements that are not drawn becomes -1
uniform int watched;    // index in `noted`, or -1 if elements are not tested
uniform bool encoded;  // true if the first three numbers are sRGB values to be converted to linear

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

bool allFinite(vec4 numbers) {
  return all(notEqual(floatBitsToUint(numbers) & 0x7f800000u, uvec4(0x7f800000u)));
}

void copyElement(int i) {
  int element = start + i * stride;
  bool drawnToo = alive < 0 || numberAt(element + alive, aliveNumber) > 0.0;
  vec4 result = fill;
  for (int c = 0; c < 4; ++c)
    if (places[c] >= 0) result[c] = numberAt(element + places[c], number);
  if (watched >= 0 && drawnToo && !allFinite(result)) {
    atomicAdd(noted[watched].x, 1u);
    atomicMin(noted[watched].y, uint(i));
  }
  if (encoded)
    for (int c = 0; c < 3; ++c) result[c] = linearOf(clamp(result[c], 0.0, 1.0));
  if (marked && !drawnToo) result.w = -1.0;
  STORE_STATE(drawn, i, result);
}

void main() {
  for (int i = int(gl_GlobalInvocationID.x); i < count; i += threads) copyElement(i);
}
