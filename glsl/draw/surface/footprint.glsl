// Texture filtering in shader code: the footprint of a pixel in a texture, with bilinear filtering, interpolation
// between mip levels, and up to four taps along the footprint's longer side (anisotropic). Compiles as GLSL and as C++.
#ifndef EXACT_FOOTPRINT
#define EXACT_FOOTPRINT
#include "common/exact.glsl"

// A uv position and its changes per pixel to the right and up.
struct Seen {
  vec2 at, across, up;
};

// A texture: size of its mip level 0 and wrap modes. Each further level has half the size, rounded down.
struct TextureShape {
  ivec2 size;
  int levels;
  ivec2 wrap;  // wrap modes along u and v, for coordinates outside 0 to 1: values of scene::Wrap
};
#define WRAP_REPEAT 0
#define WRAP_CLAMP 1
#define WRAP_MIRROR 2

struct Footprint {
  vec2 along;     // longer side of the pixel's footprint in uv
  float longer;   // length of the footprint's longer side in texels of mip level 0
  int level;
  float part;     // interpolation weight of the next mip level
  int taps;
};

// Returns the squared lengths (texels) of the footprint's two sides.
FUNCTION vec2 texelsCovered(Seen seen, ivec2 size) {
  precise vec2 across = seen.across * vec2(size);
  precise vec2 up = seen.up * vec2(size);
  precise vec2 covered = vec2(across.x * across.x + across.y * across.y, up.x * up.x + up.y * up.y);
  return min(covered, 1e12f);
}

FUNCTION Footprint footprintOf(Seen seen, TextureShape shape) {
  const int maxTaps = 4;
  vec2 covered = texelsCovered(seen, shape.size);
  float shorter = exactSqrt(min(covered.x, covered.y));
  Footprint print;
  print.longer = exactSqrt(max(covered.x, covered.y));
  print.along = covered.x >= covered.y ? seen.across : seen.up;
  precise float quarter = print.longer * 0.25f;
  float width = max(max(quarter, shorter), 1.0f);
  // The exponent bits of the width give the mip level, and the mantissa gives the weight of the next level, which is
  // linear between powers of two.
  int bits = floatBitsToInt(width);
  precise float part = intBitsToFloat((bits & 0x7fffff) | 0x3f800000) - 1.0f;
  int level = (bits >> 23) - 127;
  bool beyond = level >= shape.levels - 1;
  print.level = beyond ? shape.levels - 1 : level;
  print.part = beyond ? 0.0f : part;
  precise float ratio = print.longer * exactReciprocal(width) + 0.99f;
  print.taps = clamp(int(ratio), 1, maxTaps);
  return print;
}

FUNCTION float perTap(int taps) {
  return taps == 1 ? 1.0f : taps == 2 ? 0.5f : taps == 3 ? 0.33333334f : 0.25f;
}

// The four texels around a position in a mip level. xy: first texel; zw: last texel; `part`: position between them, 0
// to 1.
struct Around {
  ivec4 texels;
  vec2 part;
};

// Returns the coordinate, wrapped to 0 to 1, at which the texture is read.
FUNCTION float wrapped(float u, int wrap) {
  precise float whole = floor(u);
  precise float turn = u - whole;
  precise float back = 1.0f - turn;
  precise float pairs = whole * 0.5f;
  bool odd = floor(pairs) != pairs;
  return wrap == WRAP_CLAMP ? clamp(u, 0.0f, 1.0f) : wrap == WRAP_MIRROR && odd ? back : turn;
}

FUNCTION Around texelsAround(vec2 uv, int level, TextureShape shape) {
  ivec2 size = max(shape.size >> level, ivec2(1));
  vec2 place = vec2(wrapped(uv.x, shape.wrap.x), wrapped(uv.y, shape.wrap.y));
  precise vec2 corner = place * vec2(size) - 0.5f;
  precise vec2 first = floor(corner);
  precise vec2 part = corner - first;
  ivec2 a = ivec2(first), b = a + 1;
  ivec2 before = ivec2(a.x < 0 ? size.x : 0, a.y < 0 ? size.y : 0);
  ivec2 beyond = ivec2(b.x >= size.x ? size.x : 0, b.y >= size.y ? size.y : 0);
  // Beyond the border, a repeated texture continues at the opposite border. For other wrap modes, also for a mirrored
  // texture, the border texel is repeated.
  a = ivec2(shape.wrap.x == WRAP_REPEAT ? a.x + before.x : max(a.x, 0),
            shape.wrap.y == WRAP_REPEAT ? a.y + before.y : max(a.y, 0));
  b = ivec2(shape.wrap.x == WRAP_REPEAT ? b.x - beyond.x : min(b.x, size.x - 1),
            shape.wrap.y == WRAP_REPEAT ? b.y - beyond.y : min(b.y, size.y - 1));
  Around around;
  around.texels = ivec4(a, b);
  around.part = part;
  return around;
}

// Defines the function TYPE NAME(uv, footprint, shape), the filtered read of a texture whose texels are TYPE TEXEL(x,
// y, level).
#define FILTERED(TYPE, NAME, TEXEL)                                                          \
  FUNCTION TYPE NAME##Between(vec2 uv, int level, TextureShape shape) {                      \
    Around around = texelsAround(uv, level, shape);                                          \
    ivec4 t = around.texels;                                                                 \
    TYPE p = TEXEL(t.x, t.y, level), q = TEXEL(t.z, t.y, level);                             \
    TYPE r = TEXEL(t.x, t.w, level), s = TEXEL(t.z, t.w, level);                             \
    precise TYPE upper = p + (q - p) * around.part.x;                                        \
    precise TYPE lower = r + (s - r) * around.part.x;                                        \
    precise TYPE between = upper + (lower - upper) * around.part.y;                          \
    return between;                                                                          \
  }                                                                                          \
  FUNCTION TYPE NAME(vec2 uv, Footprint print, TextureShape shape) {                         \
    precise TYPE sum = TYPE(0);                                                              \
    for (int i = 0; i < print.taps; ++i) {                                                   \
      precise float aside = (float(i) + 0.5f) * perTap(print.taps) - 0.5f;                   \
      precise vec2 at = uv + print.along * aside;                                            \
      TYPE fine = NAME##Between(at, print.level, shape);                                     \
      TYPE coarse = NAME##Between(at, min(print.level + 1, shape.levels - 1), shape);        \
      sum = sum + (fine + (coarse - fine) * print.part);                                     \
    }                                                                                        \
    precise TYPE mean = sum * perTap(print.taps);                                            \
    return mean;                                                                             \
  }
#endif
