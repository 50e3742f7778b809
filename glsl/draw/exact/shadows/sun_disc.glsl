// Returns the fraction of a sun with an angular size that reaches a point. First it averages the distance of the
// casters around the point. Then it filters the map over the resulting penumbra, whose width is that distance times the
// sun's angular size (Fernando 2005, "Percentage-closer soft shadows"). The including file declares the points of
// disc_points.glsl and float casterNear(ivec2 texel), which returns 1 - depth of the caster, or a value below all
// casters if none exists. Compiles as GLSL and as C++.
#ifndef EXACT_SUN_DISC
#define EXACT_SUN_DISC
#include "common/exact.glsl"

const int discTaps = 32;  // number of points in discPoints

struct SunReceiver {
  vec2 middle;   // position of the receiver on the map in texels
  float near;    // receiver's nearness: 1 - depth; negative behind every caster
  vec2 rise;     // change of the receiver's nearness per texel along its surface; it prevents the surface's plane from
                 // shadowing itself
  float spread;  // radius of the penumbra (texels) per unit of depth between caster and receiver
  float minimum;   // min radius of the filter in texels
  float maximum;    // max radius of the filter in texels
};

// Returns the nearness of the caster at the offset `way` (texels) from the receiver if it shades the receiver, otherwise
// a value below all casters. Compares it with the nearness of the receiver's plane at the centre of the texel.
FUNCTION float shadingNear(SunReceiver r, vec2 way) {
  precise vec2 place = r.middle + way;
  vec2 texel = floor(place);
  precise vec2 centre = (texel + 0.5f) - r.middle;
  precise float plane = r.near + r.rise.x * centre.x + r.rise.y * centre.y;
  float near = casterNear(ivec2(texel));
  return near > plane ? near : -1e30f;
}

FUNCTION bool isShaded(SunReceiver r, vec2 way) {
  return shadingNear(r, way) > -1e30f;
}

// Returns the number of lit points among the four corners of a square, whose centre has the offset `way`. `aside` is
// the offset of the first corner from the centre.
FUNCTION int litOfFour(SunReceiver r, vec2 way, vec2 aside) {
  precise vec2 turned = vec2(-aside.y, aside.x);
  precise vec2 one = way + aside;
  precise vec2 two = way - aside;
  precise vec2 three = way + turned;
  precise vec2 four = way - turned;
  return (isShaded(r, one) ? 0 : 1) + (isShaded(r, two) ? 0 : 1) + (isShaded(r, three) ? 0 : 1) +
         (isShaded(r, four) ? 0 : 1);
}

FUNCTION float sunDiscFraction(SunReceiver r) {
  // Limits the search radius, because the nearness of casters is at most 1.
  precise float widest = (1.0f - r.near) * r.spread;
  float search = clamp(widest, r.minimum, r.maximum);
  int casters = 0;
  precise float sum = 0.0f;
  for (int i = 0; i < discTaps; ++i) {
    precise vec2 way = search * discPoints[i];
    float near = shadingNear(r, way);
    bool shades = near > -1e30f;
    sum = sum + (shades ? near : 0.0f);
    casters += shades ? 1 : 0;
  }
  if (casters == 0) return 1.0f;
  if (casters == discTaps) return 0.0f;
  precise float between = sum * exactReciprocal(float(casters)) - r.near;
  precise float wide = between * r.spread;
  float radius = clamp(wide, r.minimum, r.maximum);
  // The side of a square equals the spacing of the points, so the corners of all squares are spread evenly over the
  // disc. The factor 0.985 gives the corners the variance of the disc, so that the penumbra has the correct width.
  precise vec2 aside = radius * vec2(0.033f, 0.1f);
  int lit = 0;
  for (int i = 0; i < discTaps; ++i) {
    precise vec2 way = (0.985f * radius) * discPoints[i];
    lit += litOfFour(r, way, aside);
  }
  precise float fraction = float(lit) * 0.0078125f;
  return fraction;
}
#endif
