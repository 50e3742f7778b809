// Converts a field to the texture that skins read: value minus threshold, its square, and the slope. Mip levels average
// all channels, so the first two give mean and variance over any footprint. A second texture holds the mean of a ring
// around each texel; cavities are below that mean. Values are fractions of the field's range; slopes are per cell.
// COLORED: the field holds colours, with the values in alpha. One invocation writes one texel.
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
uniform float rangeLow;     // field value that maps to 0
uniform float rangeFactor;  // 1 / width of the range of field values
uniform float threshold;   // threshold as a fraction of the range
uniform float texelCells;  // number of cells per side of a texel

float aboveThreshold(ivec2 at) {
  at += texels * ivec2(lessThan(at, ivec2(0))) - texels * ivec2(greaterThanEqual(at, texels));
#ifdef COLORED
  float value = imageLoad(field, at).a;
#else
  float value = imageLoad(field, at).r;
#endif
  precise float fraction = (value - rangeLow) * rangeFactor;
  fraction = isNumber(fraction) && fraction > -1.0 ? min(fraction, 2.0) : -1.0;  // NaN also becomes -1
  precise float above = fraction - threshold;
  return above;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, texels))) return;
  float q = aboveThreshold(at);
  precise vec2 slope = vec2(aboveThreshold(at + ivec2(1, 0)) - aboveThreshold(at - ivec2(1, 0)),
                    aboveThreshold(at + ivec2(0, 1)) - aboveThreshold(at - ivec2(0, 1)));
  // The radius of the ring is half a wavelength of most patterns.
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
