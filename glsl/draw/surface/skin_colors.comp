// Writes the field's colours for skins of the look "map". COLORED: the field holds colours. One invocation writes one
// texel.
#include "draw/bindings.glsl"
#include "draw/half.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef COLORED
layout(rgba16f, binding = fieldImage) uniform readonly restrict image2D field;
#else
layout(r32f, binding = fieldImage) uniform readonly restrict image2D field;
layout(binding = stopUnit) uniform samplerBuffer stops;
uniform int stopCount;
#endif
layout(rgba16f, binding = skinColorImage) uniform writeonly restrict image2D colors;
uniform ivec2 texels;
uniform float rangeLow;     // field value that maps to 0
uniform float rangeFactor;  // 1 / width of the range of field values

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, texels))) return;
#ifdef COLORED
  vec3 color = imageLoad(field, at).rgb;
#else
  precise float fraction = (imageLoad(field, at).r - rangeLow) * rangeFactor;
  precise float place = (isNumber(fraction) && fraction > 0.0 ? min(fraction, 1.0) : 0.0) * float(stopCount - 1);
  int stop = min(int(place), max(stopCount - 2, 0));
  precise float rest = place - float(stop);
  vec3 color = exactMix(texelFetch(stops, stop).rgb, texelFetch(stops, min(stop + 1, stopCount - 1)).rgb, rest);
#endif
  imageStore(colors, at, asHalf(vec4(color, 1.0)));
}
