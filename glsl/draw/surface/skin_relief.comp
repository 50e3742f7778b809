// A field as skins read it: how far each value lies above the threshold, the square of that, and the slope. Mip maps
// average all of it, so that the first two give mean and variance of whatever a pixel covers. Beside it the mean of a
// ring around, below which cavities lie. Values are fractions of the field's range, slopes are per cell. COLORED: the
// field is a picture with the values' shares in its alpha.
#include "draw/bindings.glsl"
#include "draw/half.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef COLORED
layout(rgba16f, binding = fieldImage) uniform readonly restrict image2D field;
#else
layout(r32f, binding = fieldImage) uniform readonly restrict image2D field;
#endif
layout(rgba16f, binding = reliefImage) uniform writeonly restrict image2D relief;
layout(r16f, binding = surroundingsImage) uniform writeonly restrict image2D around;
uniform ivec2 texels;
uniform float rangeLow;     // value that counts as 0
uniform float rangeFactor;  // on what is above it
uniform float threshold;   // fraction of the range
uniform float texelCells;  // cells a texel on a side

float aboveThreshold(ivec2 at) {
  at += texels * ivec2(lessThan(at, ivec2(0))) - texels * ivec2(greaterThanEqual(at, texels));
#ifdef COLORED
  float value = imageLoad(field, at).a;
#else
  float value = imageLoad(field, at).r;
#endif
  precise float fraction = (value - rangeLow) * rangeFactor;
  fraction = isNumber(fraction) && fraction > -1.0 ? min(fraction, 2.0) : -1.0;  // lost numbers too
  precise float above = fraction - threshold;
  return above;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, texels))) return;
  float q = aboveThreshold(at);
  precise vec2 slope = vec2(aboveThreshold(at + ivec2(1, 0)) - aboveThreshold(at - ivec2(1, 0)),
                    aboveThreshold(at + ivec2(0, 1)) - aboveThreshold(at - ivec2(0, 1)));
  // Half a wavelength of most patterns away.
  ivec2 far = min(ivec2(4), texels - 1), near = min(ivec2(3), texels - 1);
  precise float ring = aboveThreshold(at + ivec2(far.x, 0)) + aboveThreshold(at - ivec2(far.x, 0)) +
               aboveThreshold(at + ivec2(0, far.y)) + aboveThreshold(at - ivec2(0, far.y)) +
               aboveThreshold(at + near) + aboveThreshold(at - near) +
               aboveThreshold(at + ivec2(near.x, -near.y)) + aboveThreshold(at + ivec2(-near.x, near.y));
  precise float mean = 0.125 * ring;
  precise vec4 texel = vec4(q, q * q, slope * (0.5 * exactReciprocal(texelCells)));
  imageStore(around, at, asHalf(vec4(mean)));
  imageStore(relief, at, asHalf(texel));
}
