// NaN in a user's buffer gets one sign and payload: those of an operation are the machine's.
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer WordsBlock { uint words[]; };
layout(std430, binding = 1) readonly buffer FloatBlock { uint floats[]; };  // of an element's words: 1 for floats
uniform int count;   // words
uniform int start;   // word of the first element
uniform int stride;  // words of an element

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count || floats[i % stride] == 0u) return;
  uint bits = words[start + i] & 0x7fffffffu;
  if (bits > 0x7f800000u) words[start + i] = 0x7fc00000u;
}
