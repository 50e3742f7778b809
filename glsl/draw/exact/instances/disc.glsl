// Discs in the picture, in pixels. Compiles as GLSL and as C++.
#include "common/exact.glsl"

struct Disc {
  vec2 middle;
  float radius;
};

// Returns the rectangle (first pixel, last pixel) of the pixels whose centres may lie on the disc. If none exist,
// last < first.
FUNCTION ivec4 pixelsOfDisc(Disc disc, ivec2 size) {
  precise vec2 low = disc.middle - disc.radius + 0.5f;
  precise vec2 high = disc.middle + disc.radius - 0.5f;
  vec2 maximum = vec2(size);
  precise vec2 last = maximum - 1.0f;
  vec2 from = clamp(low, vec2(0.0f), maximum), to = clamp(high, vec2(-1.0f), last);
  return ivec4(int(floor(from.x)), int(floor(from.y)), int(floor(to.x)), int(floor(to.y)));
}

// Returns the squared distance between the centres of the pixel and the disc, in pixels.
FUNCTION float squareFromMiddle(Disc disc, ivec2 pixel) {
  precise vec2 aside = vec2(pixel) + 0.5f - disc.middle;
  precise float square = aside.x * aside.x + aside.y * aside.y;
  return square;
}

FUNCTION bool onDisc(Disc disc, ivec2 pixel) {
  precise float maximum = disc.radius * disc.radius;
  return squareFromMiddle(disc, pixel) <= maximum;
}
