// Light of a uniformly bright rectangle that shines only to its front. Compiles as GLSL and as C++.
// A polygon of luminance L gives a surface of normal n the illuminance E = L n.F. The vector irradiance F is half the
// sum over the polygon's sides of the angle that the side spans, times the unit normal of the plane through the
// receiving point and the side. Only the part of the polygon above the surface's horizon counts (Lambert 1760; for
// instance Arvo, "Applications of irradiance tensors", SIGGRAPH 1995).
#include "draw/arithmetic.glsl"
#include "draw/surface/shading.glsl"

// Returns acos(c) / sqrt(1 - c^2), computed with acos(x) = sqrt(1 - x) (a0 + a1 x + ...), error below 2e-8 (Abramowitz
// and Stegun, 4.4.46).
FUNCTION float angleOverSine(float c) {
  float x = min(abs(c), 1.0f);
  ROUNDED float high = ((-0.0012624911f * x + 0.0066700901f) * x - 0.0170881256f) * x + 0.0308918810f;
  ROUNDED float series = (((high * x - 0.0501743046f) * x + 0.0889789874f) * x - 0.2145988016f) * x + 1.5707963050f;
  ROUNDED float acute = series * inverseRoot(1.0f + x);
  if (c >= 0.0f) return acute;
  ROUNDED float sine2 = 1.0f - x * x;
  ROUNDED float obtuse = 3.14159265f * inverseRoot(max(sine2, 1e-12f)) - acute;
  return obtuse;
}

// Returns twice the contribution to n.F of the polygon side from a to b, which are relative to the receiving point. The
// result is positive for sides that run counter-clockwise as seen from the receiving point.
FUNCTION float sideShare(vec3 a, vec3 b, vec3 normal) {
  vec3 from = unitOf(a), to = unitOf(b);
  ROUNDED float share = dotted(crossed(to, from), normal) * angleOverSine(dotted(from, to));
  return share;
}

// State of a traversal of a polygon's sides that clips the polygon at the horizon of a surface with `normal`.
struct Horizon {
  vec3 normal;
  vec3 left;     // point where the traversal goes below the horizon
  vec3 back;     // point where the traversal comes back above the horizon
  float crossed; // number of horizon crossings
  float sum;     // sum of the sides' contributions
};
FUNCTION Horizon walked(Horizon h, vec3 a, vec3 b) {
  float up = dotted(a, h.normal), after = dotted(b, h.normal);
  if (up <= 0.0f && after <= 0.0f) return h;
  ROUNDED vec3 way = b - a;
  if (up > 0.0f && after > 0.0f) {
    ROUNDED float both = h.sum + sideShare(a, b, h.normal);
    h.sum = both;
    return h;
  }
  ROUNDED float along = up * inverse(up - after);
  ROUNDED vec3 level = a + along * way;
  ROUNDED float one = h.sum + (up > 0.0f ? sideShare(a, level, h.normal) : sideShare(level, b, h.normal));
  h.sum = one;
  h.crossed = h.crossed + 1.0f;
  if (up > 0.0f)
    h.left = level;
  else
    h.back = level;
  return h;
}

// Returns n.F at the point p for the rectangle with the corners `middle` +- `across` +- `up` (m). The rectangle's front
// is on the side of cross(across, up).
FUNCTION float rectangleShare(vec3 p, vec3 normal, vec3 middle, vec3 across, vec3 up) {
  ROUNDED vec3 to = middle - p;
  if (dotted(to, crossed(across, up)) >= 0.0f) return 0.0f;
  ROUNDED vec3 a = to - across - up;
  ROUNDED vec3 b = to + across - up;
  ROUNDED vec3 c = to + across + up;
  ROUNDED vec3 d = to - across + up;
  Horizon h;
  h.normal = normal;
  h.left = to;
  h.back = to;
  h.crossed = 0.0f;
  h.sum = 0.0f;
  h = walked(h, a, b);
  h = walked(h, b, c);
  h = walked(h, c, d);
  h = walked(h, d, a);
  ROUNDED float closed = h.sum + (h.crossed > 1.5f ? sideShare(h.left, h.back, normal) : 0.0f);
  ROUNDED float share = 0.5f * closed;
  return max(share, 0.0f);
}

// Returns the unit vector from p to the point of the rectangle that is nearest to the ray in direction `mirrored`.
FUNCTION vec3 towardsRectangle(vec3 p, vec3 mirrored, vec3 middle, vec3 across, vec3 up) {
  vec3 front = unitOf(crossed(across, up));
  ROUNDED vec3 to = middle - p;
  ROUNDED float along = dotted(to, front) * inverse(min(dotted(mirrored, front), -1e-3f));
  ROUNDED vec3 hit = along * mirrored - to;
  ROUNDED float x = dotted(hit, across) * inverse(dotted(across, across));
  ROUNDED float y = dotted(hit, up) * inverse(dotted(up, up));
  ROUNDED vec3 place = to + clamp(x, -1.0f, 1.0f) * across + clamp(y, -1.0f, 1.0f) * up;
  return unitOf(place);
}

// Returns the specular lobe of shading.glsl for a rectangle, evaluated for the direction `light`. The rectangle widens
// the lobe, and the lobe's height is divided by the factor of this widening (idea: Karis, "Real shading in Unreal
// Engine 4", SIGGRAPH 2013). The light directions of a lobe cover about 4 pi alpha^2 lh, where lh is the cosine between
// `light` and the half vector, because half vectors cover pi alpha^2 and turn half as fast. `spread2` is the solid
// angle of the rectangle / pi. `lit` is n.F of the rectangle. The shadowing term uses the mean cosine lit / spread2,
// because light comes from the whole rectangle rather than from one direction.
FUNCTION vec2 rectangleLobe(vec3 normal, vec3 view, vec3 light, float lit, float alpha, float spread2) {
  ROUNDED float alpha2 = alpha * alpha;
  ROUNDED float cosine2 = 0.5f + 0.5f * dotted(view, light);
  ROUNDED float wide = alpha2 + 0.25f * spread2 * inverseRoot(max(cosine2, 1e-4f));
  ROUNDED float lower = alpha2 * inverse(wide);
  float nl = dotted(normal, light);
  ROUNDED float mean = lit * inverse(max(spread2, 1e-6f));
  vec2 lobed = lowerLobe(normal, view, light, clamp(mean, nl, 1.0f), alpha, lower);
  return nl > 0.0f ? lobed : vec2(0.0f);
}

// Returns the approximate solid angle of the rectangle / pi.
FUNCTION float rectangleSpread(vec3 p, vec3 middle, vec3 across, vec3 up) {
  ROUNDED vec3 to = p - middle;
  float perDistance = inverseRoot(max(dotted(to, to), 1e-12f));
  ROUNDED float facing = 4.0f * dotted(to, crossed(across, up)) * perDistance;
  ROUNDED float spread2 = max(facing, 0.0f) * perDistance * perDistance * 0.318309886f;
  return min(spread2, 1.0f);
}
