// Light of the surroundings, weighed by cosines, that does not reach a place for what stands around it (J. Jimenez et al.,
// "Practical realtime strategies for accurate indirect occlusion", SIGGRAPH 2016). Compiles as GLSL and as C++. Whoever includes
// it has `view`, float nearnessAt(ivec2 half pixel), 0 outside the picture, SLICES, STEPS, and vec3 reach_: how far away what counts
// may be (m), at most (half pixels), and half pixels a metre at depth 1.
//
// A slice is the plane through the eye that the picture shows as a line through the half pixel. With the ray r there and what a
// half pixel along the line adds to rays, u, the place that is seen t half pixels on at depth e is e (r + t u), so from the place
// here, d r, the direction is that of r (1 - d / e) + t u: of two numbers, along r and across it. The horizon on either side is
// the highest such direction, as an angle h from that to the eye; with the normal's angle g in that plane, the light between is
//     (cos g - cos(2 h - g) + 2 h sin g) / 4
// for each side, and cos g + g sin g in all where nothing stands. Nearness is affine on planes, so what lies between two half
// pixels is estimated along the plane of the place itself: on that, it is right.
//
// PARALLEL: rays go along f, and nearness is metres before what is never seen, so the direction is that of f times how much less near the
// place there is, and t u across.
#include "common/exact_acos.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/occlusion/half_pixels.glsl"

struct HalfPlace {
  ivec2 at;
  float nearness;  // 1/m
  float depth;     // m
  vec2 slope;      // of nearness
  float reach;     // half pixels
  float perReach;  // of one (1/m)
};

struct Slice {
  vec2 along;           // on the picture, unit
  float ray;            // lengths: of the ray,
  float forth, across;  // of what a half pixel adds to it, along it and across
  float sine, cosine;   // of the normal's angle from the direction to the eye
  float weight;         // of the slice among others: of the normal's part in it, and of how wide it is around that direction
};

// What keeps light out, and all the light there were.
struct Arcs {
  float lost;
  float all_;
};

FUNCTION HalfPlace halfPlaceOf(ivec2 at, float here) {
  float left = nearnessAt(at - ivec2(1, 0)), right = nearnessAt(at + ivec2(1, 0));
  float above = nearnessAt(at - ivec2(0, 1)), below = nearnessAt(at + ivec2(0, 1));
  float depth = exactReciprocal(here);
#ifdef PARALLEL
  precise float asked = reach_.x * reach_.z;
  float reach = min(asked, reach_.y);
  float held = reach;
#else
  precise float asked = reach_.x * reach_.z * here;
  float reach = min(asked, reach_.y);
  precise float held = reach * depth;
#endif
  precise float perReach = reach_.z * exactReciprocal(max(held, 1e-12f));
  HalfPlace place;
  place.at = at;
  place.nearness = here;
  place.depth = depth;
  place.slope = vec2(slopeBetween(left, here, right), slopeBetween(above, here, below));
  place.reach = max(reach, 1.0f);
  place.perReach = perReach;
  return place;
}

// Of one side, of what the formula above says of both.
FUNCTION float arcTo(float cosine, float normalSine, float normalCosine) {
  precise float square = 1.0f - cosine * cosine;
  float sine = exactSqrt(max(square, 0.0f));
  float angled = clamp(cosine, -1.0f, 1.0f);
  precise float twice = 2.0f * cosine * cosine - 1.0f;
  precise float twiceSine = 2.0f * cosine * sine;
  precise float arc = 0.25f * (normalCosine - (twice * normalCosine + twiceSine * normalSine)) +
                      0.5f * exactAcos(angled) * normalSine;
  return arc;
}

// The cosine of the horizon's angle on a side, 1 or -1. What is as far as the reach does not count, what is nearer than 4/9 of it
// does in full. Steps are shorter the nearer they are; `shift` (0 to 1) of one.
FUNCTION float horizonOf(HalfPlace place, Slice slice, float side, float shift) {
  precise float low = -side * slice.sine;
  precise float horizon = low;
  for (int k = 0; k < STEPS; ++k) {
    precise float part = (float(k) + shift) * exactReciprocal(float(STEPS));
    precise float away = (1.0f + (place.reach - 1.0f) * part * (0.7f + 0.3f * part)) * side;
    precise vec2 exact = slice.along * away;
    precise vec2 later = exact + 0.5f;
    vec2 middle = floor(later);
    float seen = nearnessAt(place.at + ivec2(middle));
    precise vec2 beside = exact - middle;
    precise float nearness = seen + (place.slope.x * beside.x + place.slope.y * beside.y);
#ifdef PARALLEL
    precise float up = nearness - place.nearness;
#else
    precise float up = (nearness * place.depth - 1.0f) * slice.ray - away * slice.forth;
#endif
    precise float over = away * slice.across;
    precise float square = up * up + over * over;
    float perLength = exactInverseSqrt(square);
#ifdef PARALLEL
    float perAway = place.perReach;
#else
    precise float perAway = place.perReach * exactReciprocal(max(nearness, 1e-9f));
#endif
    precise float counts = 1.25f - 1.25f * square * perAway * perAway;
    float share = seen > 0.0f ? clamp(counts, 0.0f, 1.0f) : 0.0f;
    precise float higher = low + (up * perLength - low) * share;
    horizon = max(horizon, higher);
  }
  return horizon;
}

// |N| of the plane's normal N that has N . r = -nearness and N . u = -slope . along.
FUNCTION float normalLength(HalfPlace place, vec3 ray, vec3 across, vec3 down) {
#ifdef PARALLEL
  precise vec2 tilt = place.slope * vec2(exactInverseSqrt(exactDot(across, across)), exactInverseSqrt(exactDot(down, down)));
  precise float tilted = 1.0f + tilt.x * tilt.x + tilt.y * tilt.y;
  return exactSqrt(tilted);
#endif
  vec3 both = exactCross(across, down), overRay = exactCross(down, ray), rayOver = exactCross(ray, across);
  precise vec3 normal = place.slope.x * overRay + place.slope.y * rayOver + place.nearness * both;
  precise float length_ = exactSqrt(exactDot(normal, normal)) * exactReciprocal(exactDot(both, ray));
  return length_;
}

// The slice of that turn, 0 to 1 being half of one. `perNormal`: 1 / |N|.
FUNCTION Slice sliceOf(HalfPlace place, vec3 ray, vec3 right, vec3 down, float turn, float perNormal) {
  precise float angle = 3.14159265f * turn;
  vec2 along = vec2(exactCos(angle), exactSin(angle));
  precise vec3 more = along.x * right + along.y * down;
  float square = exactDot(ray, ray);
  float perRay = exactInverseSqrt(square);
  precise float length_ = square * perRay;
  precise float forth = exactDot(more, ray) * perRay;
  precise float acrossSquare = exactDot(more, more) - forth * forth;
  float perAcross = exactInverseSqrt(acrossSquare);
  precise float across = acrossSquare * perAcross;
#ifdef PARALLEL
  const float towards = 1.0f;
#else
  precise float towards = place.nearness * perRay;
#endif
  precise float aside = (forth * towards - (place.slope.x * along.x + place.slope.y * along.y)) * perAcross;
  precise float part = towards * towards + aside * aside;
  float perPart = exactInverseSqrt(part);
  precise float sine = aside * perPart;
  precise float cosine = towards * perPart;
  precise float weight = part * perPart * perNormal * (exactDot(right, right) * perAcross * perAcross);
  Slice slice;
  slice.along = along;
  slice.ray = length_;
  slice.forth = forth;
  slice.across = across;
  slice.sine = sine;
  slice.cosine = cosine;
  slice.weight = weight;
  return slice;
}

// Of a place that shows something. Any 4x4 half pixels have 16 turns, and their steps are shifted evenly.
FUNCTION Arcs arcsOf(HalfPlace place) {
  vec3 ray = directionOf(rayThrough(vec2(2 * place.at + 1)));
  precise vec3 right = 2.0f * vec3(view.rayAcross);
  precise vec3 down = 2.0f * vec3(view.rayDown);
  float perNormal = exactReciprocal(max(normalLength(place, ray, right, down), 1e-12f));
  int turned = ((place.at.x + place.at.y) & 3) * 4 + (place.at.x & 3);
  precise float lost = 0.0f;
  precise float all_ = 0.0f;
  for (int i = 0; i < SLICES; ++i) {
    precise float turn = (float(i) + float(turned) * 0.0625f) * exactReciprocal(float(SLICES));
    precise float shift = float((place.at.y - place.at.x + 2 * i) & 3) * 0.25f + 0.0625f;
    precise float otherShift = shift + 0.125f;
    Slice slice = sliceOf(place, ray, right, down, turn, perNormal);
    precise float otherSine = -slice.sine;
    float horizon = horizonOf(place, slice, 1.0f, shift), other = horizonOf(place, slice, -1.0f, otherShift);
    precise float open = slice.cosine + exactAcos(min(slice.cosine, 1.0f)) * abs(slice.sine);
    precise float seen = arcTo(horizon, slice.sine, slice.cosine) + arcTo(other, otherSine, slice.cosine);
    precise float less = open - seen;
    lost = lost + slice.weight * max(less, 0.0f);
    all_ = all_ + slice.weight * open;
  }
  Arcs arcs;
  arcs.lost = lost;
  arcs.all_ = all_;
  return arcs;
}
