// Averages a field's cells into the texels of a texture. COLORED: averages light instead of values. The arithmetic is
// exact for both rasterizers. One invocation writes one texel.
#define EXACT_PICTURE
#include "draw/arithmetic.glsl"
#include "draw/overlay/field_inputs.glsl"
#include "draw/overlay/field_values.glsl"
#include "draw/overlay/field_means.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef COLORED
layout(rgba16f, binding = targetImage) writeonly uniform restrict image2D texels;
#else
layout(r32f, binding = targetImage) writeonly uniform restrict image2D texels;
#endif
uniform ivec2 size;  // size of the texture in texels

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, size))) return;
  imageStore(texels, at, texelMean(at, size));
}
