// Cosine-weighted ambient light that objects around a point occlude (J. Jimenez et al., "Practical realtime strategies
// for accurate indirect occlusion", SIGGRAPH 2016). Compiles as GLSL and as C++. The including file declares `view`,
// SLICES, STEPS, float nearnessAt(ivec2 half pixel), which is 0 outside the picture, and vec3 reach_: max distance of
// occluders (m), max distance (half pixels), half pixels per metre at depth 1.
// A slice is a plane through the eye, visible as a line through the half pixel. Let d be the depth of the shaded point,
// r the ray of the half pixel and u the change of r per half pixel along the line. The point that is visible t half
// pixels further, at depth e, is e (r + t u). Seen from the shaded point d r, its direction is r (1 - d / e) + t u,
// which has one component along r and one across r. The horizon on each side is the highest of these directions, given
// as its angle h from the direction to the eye. With the angle g of the normal in that plane, the light below the
// horizon is (cos g - cos(2 h - g) + 2 h sin g) / 4 for each side, and cos g + g sin g in total without occluders.
// Nearness is affine on planes, so samples between two half pixels are estimated along the plane of the shaded point.
// For points of that plane the estimate is exact.
// PARALLEL: all rays go along f, and nearness is the distance (m) from the far end of the depth range. The direction is
// f times the nearness difference, plus t u across.
#include "common/exact_acos.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/occlusion/half_pixels.glsl"

struct HalfPlace {
  ivec2 at;
  float nearness;  // nearness of the shaded point in 1/m
  float depth;     // depth of the shaded point in metres
  vec2 slope;      // change of nearness (half_pixels.glsl) from one half pixel to the next along x and y
  float reach;     // max distance of occluders in half pixels
  float perReach;  // 1 / max distance of occluders, in 1/m
};

struct Slice {
  vec2 along;           // unit direction of the slice in the picture
  float ray;            // length of the half pixel's ray
  float forth, across;  // change of the ray per half pixel along the slice: component along the ray, and component
                        // across it
  float sine, cosine;   // sine and cosine of the angle between the normal and the direction to the eye, in the slice's
                        // plane
  float weight;         // weight of the slice: length of the normal's projection onto the slice's plane, times the
                        // slice's angular width
};

// Ambient light: the occluded part and the total.
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

// Returns the light of one side by the formula in the comment at the start of this file.
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

// Returns the cosine of the horizon angle on one side (1 or -1). Occluders beyond the max distance do not count;
// occluders closer than 4/9 of it count fully. Steps get shorter towards the point. `shift` (0 to 1) offsets the steps
// by a fraction of a step.
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

// Returns |N|, where N is the vector along the plane's normal with N . r = -nearness and N . u = -slope . along.
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

// Returns the slice at the angle `turn`, where 0 to 1 means half a turn. `perNormal` is 1 / |N|.
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

// Returns the light of a half pixel that is not empty. Each 4x4 block of half pixels uses 16 different angles and 16
// evenly spaced offsets of the steps.
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
