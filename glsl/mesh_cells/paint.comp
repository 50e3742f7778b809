// Colours each vertex by the value of its cell. One invocation per vertex.
#include "common/exact.glsl"
#include "common/words.glsl"
#include "mesh_cells/bindings.glsl"
layout(local_size_x = 64) in;
layout(binding = cellValuesUnit) uniform usamplerBuffer cellWords;
INPUT_WORDS(restBinding, RestBlock, rest)
layout(std430, binding = paintedBinding) restrict writeonly buffer PaintedBlock { vec4 painted[]; };
uniform int count, firstWord;
uniform vec2 range;  // Lowest value, and 1 / (highest value - lowest value)

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  uvec4 vertex = LOAD_INPUT_WORDS(rest, i);
  int word = firstWord + int(vertex.w);
  uvec4 four = texelFetch(cellWords, word >> 2);
  uint bits = (word & 2) == 0 ? ((word & 1) == 0 ? four.x : four.y) : ((word & 1) == 0 ? four.z : four.w);
  float value = uintBitsToFloat(bits);
  value = isNumber(value) ? clamp(value, -1e20, 1e20) : -1e20;
  precise float share = (value - range.x) * range.y;
  precise float color = clamp(share, 0.0, 1.0) * 1023.0 + 0.5;
  painted[i] = vec4(uintBitsToFloat(vertex.xyz), floor(color));
}
