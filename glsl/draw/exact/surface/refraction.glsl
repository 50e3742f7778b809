// Follows a ray through a clear solid from the two points where the straight ray crosses its surface (C. Wyman, "An
// approximate image-space approach for interactive refraction", SIGGRAPH 2005). The surface where the refracted ray
// leaves the solid is unknown. It is the plane of the straight ray's exit if the entry is flat, and the sphere that fits
// the entry if that sphere also fits the exit; both are blended in between. Slabs and balls are therefore exact. Compiles
// as GLSL and as C++.
#ifndef EXACT_REFRACTION
#define EXACT_REFRACTION
#include "draw/exact/rays/dielectric.glsl"

struct Crossing {
  vec3 place;      // point where the ray leaves the solid
  vec3 direction;  // unit direction of the ray beyond the solid
  float metres;    // length of the ray in the solid
};

// Returns the unit direction of a ray in the solid after it meets the surface with the outward normal n from inside: it
// is refracted, or mirrored by total internal reflection.
FUNCTION vec3 directionOut(vec3 inside, vec3 n, float ior) {
  float cosine = exactDot(inside, n);
  precise float under = 1.0f - ior * ior * (1.0f - cosine * cosine);
  precise vec3 mirrored = inside - n * (2.0f * cosine);
  vec3 out_ = refractedDirection(-inside, -n, ior);
  return cosine <= 0.0f ? inside : under <= 0.0f ? mirrored : out_;
}

// Returns the ray that enters the solid at `place`. `towards`: unit vector to the eye; n: outward normal; `curvature`: of
// the surface there (1/m, 0 for a plane); `exit`, exitNormal: where the straight ray leaves, with the outward normal.
FUNCTION Crossing crossingOf(vec3 place, vec3 towards, vec3 n, float curvature, vec3 exit, vec3 exitNormal, float ior) {
  float eta = exactReciprocal(ior);
  float cosine = max(exactDot(towards, n), 1e-3f);
  vec3 inside = refractedDirection(towards, n, eta);
  float beyond = max(-exactDot(inside, n), 1e-3f);
  precise vec3 straight = exit - place;
  precise float square = exactDot(straight, straight);
  float chord = exactSqrt(square);
  // A sphere of curvature k has chords of 2 cosine / k. The solid counts as a ball if its chord is 3/4 of that or more.
  precise float round_ = curvature * chord * exactReciprocal(cosine) - 0.5f;
  float share = clamp(round_, 0.0f, 1.0f);
  precise float flat_ = chord * cosine * exactReciprocal(beyond);
  precise float ball = 2.0f * beyond * exactReciprocal(max(curvature, 1e-9f));
  precise float metres = share > 0.0f ? flat_ + (ball - flat_) * share : flat_;
  precise vec3 left = place + inside * metres;
  precise vec3 onBall = n + (left - place) * curvature;
  precise vec3 turned = exitNormal + (onBall - exitNormal) * share;
  float perLength = exactInverseSqrt(max(exactDot(turned, turned), 1e-12f));
  precise vec3 last = turned * perLength;
  Crossing crossing;
  crossing.place = left;
  crossing.direction = directionOut(inside, last, ior);
  crossing.metres = metres;
  return crossing;
}

// Returns the fraction of light that remains after `metres` in a solid that absorbs `absorbed` (1/m).
FUNCTION vec3 leftAfter(vec3 absorbed, float metres) {
  precise vec3 depth = absorbed * -metres;
  return vec3(exactExp(depth.x), exactExp(depth.y), exactExp(depth.z));
}
#endif
