// Copies a user's texture into an array of four words per texel, x fastest, as simulation state and for drawing. Each
// invocation takes every `threads`-th texel. WHOLE is defined if the texels are integers.
#include "common/words.glsl"
layout(local_size_x = 64) in;
layout(binding = 7) uniform SAMPLER source;
STATE_WORDS(0, TexelBlock, texels)
uniform ivec4 size;   // size in texels; w is 0
uniform int threads;  // number of invocations

void copyTexel(int i) {
  ivec3 at = ivec3(i % size.x, i / size.x % size.y, i / size.x / size.y);
#ifdef WHOLE
  STORE_WORDS(texels, i, uvec4(texelFetch(source, at.PLACE, 0)));
#else
  uvec4 bits = floatBitsToUint(texelFetch(source, at.PLACE, 0));
  // Each NaN gets a canonical sign and payload, and -0 becomes 0, because machines produce different ones.
  for (int c = 0; c < 4; ++c) {
    uint magnitude = bits[c] & 0x7fffffffu;
    bits[c] = magnitude > 0x7f800000u ? 0x7fc00000u : magnitude == 0u ? 0u : bits[c];
  }
  STORE_WORDS(texels, i, bits);
#endif
}

void main() {
  for (int i = int(gl_GlobalInvocationID.x); i < size.x * size.y * size.z; i += threads) copyTexel(i);
}
