// Finds the pixel of a view through one point of the lens that shows what another point of the lens, near it, would
// show. A point with nearness n is displaced by (lens.x - lens.y n) pixels if the eye moves by the radius of the lens.
// The including file declares float nearnessAt(ivec2 at). Compiles as GLSL and as C++.
#ifndef EXACT_LENS_SHIFT
#define EXACT_LENS_SHIFT
#include "common/exact.glsl"
#include "common/hash.glsl"

const int pointsAPixel = 4;  // number of points through which a pixel looks in each view
const int shiftSteps = 10;
const float mostNearPixels = 5.0f;  // max displacement towards the eye's side of the focal plane

// Returns position `index` of a pixel's points within a square of side 1 around the views' points. The positions follow
// the R2 sequence (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018). Its start steps from pixel
// to pixel along two lattices, so that neighbours look through different points and the grain is fine.
FUNCTION vec2 pointOfPixel(ivec2 at, int index) {
  uint across = uint(at.x), down = uint(at.y), i = uint(index);
  uint x = across * 3242174889u + down * 2447445414u + i * 3242174889u;
  uint y = across * 1640531527u + down * 3518319155u + i * 2447445414u;
  precise vec2 point = 0.5f * vec2(signedUnit(x), signedUnit(y));
  return point;
}

FUNCTION ivec2 displaced(ivec2 at, vec2 way, float by, ivec2 size) {
  precise vec2 place = vec2(at) + 0.5f - way * by;
  return clamp(ivec2(floor(place)), ivec2(0), size - 1);
}

// Follows the pixel's ray through its own point from near to far in the view's picture, up to the first surface that is
// displaced as far as the ray. If nearer surfaces hide it, returns the last pixel before them, which shows what is
// behind them.
FUNCTION ivec2 shiftedFrom(ivec2 at, int index, vec3 lens, ivec2 size) {
  precise vec2 way = lens.z * pointOfPixel(at, index);
  precise float length2 = way.x * way.x + way.y * way.y;
  precise float nearest = -mostNearPixels * exactInverseSqrt(max(length2, 1e-12f));
  precise float step_ = (lens.x - nearest) * 0.111111112f;
  precise float slack = 0.75f * step_;
  ivec2 found = at;
  bool open = true;
  for (int i = 0; i < shiftSteps; ++i) {
    precise float by = nearest + float(i) * step_;
    ivec2 from = displaced(at, way, by, size);
    precise float surface = lens.x - lens.y * nearnessAt(from);
    precise float apart = surface - by;
    bool meets = abs(apart) <= slack || (i == 0 && apart < 0.0f);
    if (open && meets) found = displaced(at, way, max(surface, nearest), size);
    if (open && apart > slack) found = from;
    open = open && !meets;
  }
  return found;
}
#endif
