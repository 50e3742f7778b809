// Averages a field's cells into the texels of a texture: values, or light where COLORED. Texel i covers the
// cells from floor(i cells / size) on, so blocks differ by one cell at most and the texture ends where the
// field does: a repeated one has no seam.
#include "draw/overlay/field_cells.glsl"
#include "draw/overlay/field_colors.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef COLORED
layout(rgba16f, binding = targetImage) writeonly uniform restrict image2D texels;
#else
layout(r32f, binding = targetImage) writeonly uniform restrict image2D texels;
#endif
uniform ivec2 size;  // texels

#if CELLS == 0
/// Fraction of the bits that are set.
float meanBit(ivec2 first, ivec2 end) {
  int count = 0;
  for (int y = first.y; y < end.y; ++y) {
    int row = firstWord + y * rowWords;
    for (int w = first.x >> 5; w <= (end.x - 1) >> 5; ++w) {
      int from = max(first.x - 32 * w, 0), till = min(end.x - 32 * w, 32);
      count += bitCount(bitfieldExtract(wordAt(row + w), from, till - from));
    }
  }
  return float(count) / float((end.x - first.x) * (end.y - first.y));
}
#endif

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, size))) return;
  ivec2 first = ivec2(uvec2(at) * uvec2(cells) / uvec2(size));
  ivec2 end = ivec2(uvec2(at + 1) * uvec2(cells) / uvec2(size));
#if CELLS == 0
  float value = meanBit(first, end);
#ifdef COLORED
  vec3 color = mix(colorOf(0.0), colorOf(1.0), value);
#endif
#else
  float value = 0.0;
  vec3 color = vec3(0.0);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      float cell = valueOf(ivec2(x, y));
      value += cell;
#ifdef COLORED
      color += colorOf(cell);
#endif
    }
  float fraction = 1.0 / float((end.x - first.x) * (end.y - first.y));
  value *= fraction;
  color *= fraction;
#endif
#ifdef COLORED
  imageStore(texels, at, vec4(color, placeOf(value)));
#else
  imageStore(texels, at, vec4(value, 0.0, 0.0, 0.0));
#endif
}
