// Texels of a user's texture as four words each, x fastest: its state, and what is drawn of it.
#include "common/words.glsl"
layout(local_size_x = 64) in;
layout(binding = 7) uniform SAMPLER source;
STATE_WORDS(0, TexelBlock, texels)
uniform ivec4 size;  // texels; w: 0

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y * size.z) return;
  ivec3 at = ivec3(i % size.x, i / size.x % size.y, i / size.x / size.y);
#ifdef WHOLE
  STORE_WORDS(texels, i, uvec4(texelFetch(source, at.PLACE, 0)));
#else
  STORE_WORDS(texels, i, floatBitsToUint(texelFetch(source, at.PLACE, 0)));
#endif
}
