// Copies a user's texture into an array of four words per texel, x fastest, as simulation state and for drawing. One
// invocation per texel. WHOLE is defined if the texels are integers.
#include "common/words.glsl"
layout(local_size_x = 64) in;
layout(binding = 7) uniform SAMPLER source;
STATE_WORDS(0, TexelBlock, texels)
uniform ivec4 size;  // size in texels; w is 0

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y * size.z) return;
  ivec3 at = ivec3(i % size.x, i / size.x % size.y, i / size.x / size.y);
#ifdef WHOLE
  STORE_WORDS(texels, i, uvec4(texelFetch(source, at.PLACE, 0)));
#else
  uvec4 bits = floatBitsToUint(texelFetch(source, at.PLACE, 0));
  // Replaces each NaN by a NaN with a canonical sign and payload, because machines produce different NaNs.
  for (int c = 0; c < 4; ++c)
    if ((bits[c] & 0x7fffffffu) > 0x7f800000u) bits[c] = 0x7fc00000u;
  STORE_WORDS(texels, i, bits);
#endif
}
