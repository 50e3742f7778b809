// Haze along rays (HAZE). Air lets the fraction exp(-t) of light through, where t is the optical depth, and adds the
// fraction 1 - exp(-t) of its own radiance (Beer-Lambert law). Its density falls to 1/e per scale height. Haze does not
// dim the light that sun, sky and lamps send to surfaces. HAZE 1: its radiance is the sky's in the ray's direction, or
// the horizon's if the ray descends. HAZE 2: its radiance is frame.hazeColor. The including file declares `view` and
// `frame`. Compiles as GLSL and as C++.
#if !defined EXACT_HAZE && defined HAZE
#define EXACT_HAZE
#include "draw/sky.glsl"

// Returns the optical depth of the way `along` (m) from a point. With u = rise of the way / scale height, the mean
// density is (d0 - d1) / u for the densities d0 and d1 at the ends, or sinh(u/2) / (u/2) times the density in the
// middle.
FUNCTION float opticalDepth(vec3 from, vec3 along) {
  precise float first = (from.y - frame.haze.w) * frame.haze.y;
  precise float u = along.y * frame.haze.y;
  precise float last = first + u;
  precise float middle = first + 0.5f * u;
  precise float s = 0.25f * u * u;
  precise float level = exactExp(-middle) * (1.0f + s * (0.16666667f + s * (8.3333333e-3f + s * 1.9841270e-4f)));
  bool steep = abs(u) > 1.0f;
  precise float rising = (exactExp(-first) - exactExp(-last)) * exactReciprocal(steep ? u : 1.0f);
  precise float depth = (steep ? rising : level) * frame.haze.x * exactSqrt(exactDot(along, along));
  return depth;
}

// Returns the optical depth of the way without its first `clear` metres.
FUNCTION float opticalDepthAfter(float clear, vec3 from, vec3 along) {
  precise float part = clear * exactInverseSqrt(max(exactDot(along, along), 1e-20f));
  float left = min(part, 1.0f);
  precise vec3 begin = from + along * left;
  precise vec3 rest = along * (1.0f - left);
  return opticalDepth(begin, rest);
}

// Returns the vector from the eye to p, or from the plane where the rays start (PARALLEL).
FUNCTION vec3 fromEye(vec3 p) {
  precise vec3 aside = p - vec3(view.eye);
#ifdef PARALLEL
  precise vec3 along = vec3(view.forward) * exactDot(vec3(view.forward), aside);
  return along;
#else
  return aside;
#endif
}

// Returns the optical depth between the eye and p.
FUNCTION float hazeBefore(vec3 p) {
  vec3 along = fromEye(p);
  precise vec3 begin = p - along;
  return opticalDepthAfter(frame.haze.z, begin, along);
}

// Returns the optical depth of a reflected or refracted ray's way `along` (m) from p.
FUNCTION float hazeBehind(vec3 p, vec3 along) {
  vec3 before = fromEye(p);
  precise float clear = frame.haze.z - exactSqrt(exactDot(before, before));
  return opticalDepthAfter(max(clear, 0.0f), p, along);
}

// Returns the fraction of light that the optical depth lets through.
FUNCTION float passed(float depth) {
  return exactExp(-depth);
}

// Returns the radiance of dense haze in a unit direction, for reflected rays: without the glow around the sun. The
// environment image is blurred, because its details would appear in the haze.
FUNCTION vec3 hazeInMirror(vec3 direction) {
#if HAZE == 2
  return vec3(frame.hazeColor);
#elif defined ENVIRONMENT
  return environmentMirrored(vec3(direction.x, max(direction.y, 1e-3f), direction.z), 0.25f);
#else
  return skyRadiance(max(direction.y, 0.0f));
#endif
}

// Returns the radiance of dense haze in a unit direction, for rays from the eye.
FUNCTION vec3 hazeTowards(vec3 direction) {
#if HAZE == 2 || defined ENVIRONMENT
  return hazeInMirror(direction);
#else
  // Below the horizon, the direction's projection is shorter than 1, so the glow vanishes for a view straight down.
  vec3 level = vec3(direction.x, max(direction.y, 0.0f), direction.z);
  precise float glow = max(exactDot(level, vec3(frame.sunDirection)), 0.0f);
  glow = glow * glow;
  glow = glow * glow;
  glow = glow * glow;
  glow = glow * glow;
  precise vec3 light = hazeInMirror(direction) + vec3(frame.sunLight) * (frame.sunGlow * glow);
  return light;
#endif
}

// Returns light from p as it arrives at the eye. `alpha`: fraction of the background that the light's source covers.
// REFLECTED: `light` is a change of light, to which the haze adds nothing.
FUNCTION vec3 throughHaze(vec3 light, float alpha, vec3 p) {
  float passes = passed(hazeBefore(p));
#ifdef REFLECTED
  precise vec3 seen = light * passes;
#else
  precise vec3 seen = light * passes + hazeTowards(unitOf(fromEye(p))) * (alpha * (1.0f - passes));
#endif
  return seen;
}

// Returns light that has passed the fraction `passes` of the way along a reflected or refracted ray.
FUNCTION vec3 mirroredThroughHaze(vec3 light, float passes, vec3 direction) {
  precise vec3 seen = light * passes + hazeInMirror(direction) * (1.0f - passes);
  return seen;
}

// Returns the light of the picture where a reflected or refracted ray from p in the unit `direction` ends after
// `metres`, as it arrives at p. `light`: the picture's light times its weight w. It contains the haze between eye and object,
// which is exchanged for the haze along the ray. The light is brightened at most by exp(t) for the optical depth t
// between eye and p, because the result is dimmed by that later.
FUNCTION vec4 pictureThroughHaze(vec4 light, vec3 p, vec3 direction, float metres) {
  precise vec3 along = direction * metres;
  precise vec3 end = p + along;
  float shown = hazeBefore(end), behind = hazeBehind(p, along);
  precise vec3 plain = vec3(light) - hazeTowards(unitOf(fromEye(end))) * (light.w * (1.0f - passed(shown)));
  precise float change = shown - behind;
  precise vec3 seen = max(plain, vec3(0.0f)) * exactExp(min(change, hazeBefore(p))) +
                      hazeInMirror(direction) * (light.w * (1.0f - passed(behind)));
  return vec4(seen, light.w);
}
#endif
