// Replaces each NaN in a user's buffer by one with a canonical sign and payload, and -0 by 0, because machines produce
// different ones. Each invocation takes every `threads`-th word.
layout(local_size_x = 64) in;
layout(std430, binding = 0) buffer WordsBlock { uint words[]; };
layout(std430, binding = 1) readonly buffer FloatBlock { uint floats[]; };  // 1 if the word of an element is a float,
                                                                            // otherwise 0
uniform int count;   // number of words
uniform int start;   // word offset of the first element
uniform int stride;  // number of words per element
uniform int threads;  // number of invocations

void main() {
  for (int i = int(gl_GlobalInvocationID.x); i < count; i += threads) {
    if (floats[i % stride] == 0u) continue;
    uint bits = words[start + i] & 0x7fffffffu;
    if (bits > 0x7f800000u) words[start + i] = 0x7fc00000u;
    if (bits == 0u) words[start + i] = 0u;
  }
}
