// Samples directions: from discs, cosine hemispheres and GGX lobes. Compiles as GLSL and as C++.
#ifndef EXACT_RAY_DIRECTIONS
#define EXACT_RAY_DIRECTIONS
#include "draw/exact/rays/ray_shapes.glsl"

// Returns a uniformly distributed point of the unit disc.
FUNCTION vec2 onDisc(float u, float v) {
  precise float turn = 6.2831853f * v;
  float radius = exactSqrt(u);
  precise vec2 at = vec2(exactCos(turn), exactSin(turn)) * radius;
  return at;
}

// Returns a direction around the unit normal n with a probability proportional to the cosine.
FUNCTION vec3 cosineDirection(vec3 n, float u, float v) {
  vec2 at = onDisc(u, v);
  precise float high = 1.0f - u;
  precise vec3 direction = rightOf(n) * at.x + upOf(n) * at.y + n * exactSqrt(high);
  return direction;
}

// Returns a GGX microfacet normal sampled from the normals visible from `view`, in tangent coordinates with z along the
// normal (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023).
FUNCTION vec3 visibleNormal(vec3 view, float alpha, float u, float v) {
  precise vec3 wide = vec3(view.x * alpha, view.y * alpha, view.z);
  precise vec3 w = wide * exactInverseSqrt(exactDot(wide, wide));
  precise float turn = 6.2831853f * u;
  precise float z = (1.0f - v) * (1.0f + w.z) - w.z;
  precise float round = 1.0f - z * z;
  float aside = exactSqrt(clamp(round, 0.0f, 1.0f));
  precise vec3 h = vec3(aside * exactCos(turn), aside * exactSin(turn), z) + w;
  precise vec3 narrow = vec3(h.x * alpha, h.y * alpha, max(h.z, 1e-6f));
  precise vec3 n = narrow * exactInverseSqrt(exactDot(narrow, narrow));
  return n;
}

// Returns the density of the GGX normal distribution (1/sr) at the given cosine.
FUNCTION float ggxDensity(float cosine, float alpha) {
  precise float a2 = alpha * alpha;
  precise float under = cosine * cosine * (a2 - 1.0f) + 1.0f;
  precise float held = max(under, 1e-7f);
  precise float squared = held * held;
  precise float d = 0.31830989f * a2 * exactReciprocal(squared);
  return d;
}

// Returns Smith's Lambda for GGX at the given cosine, which must be above 0.
FUNCTION float ggxLambda(float cosine, float alpha) {
  precise float c2 = cosine * cosine;
  precise float tangent2 = (1.0f - min(c2, 1.0f)) * exactReciprocal(max(c2, 1e-8f));
  precise float inside = 1.0f + alpha * alpha * tangent2;
  precise float lambda = 0.5f * exactSqrt(inside) - 0.5f;
  return lambda;
}

// Returns Schlick's Fresnel term for the reflectance f0 at normal incidence.
FUNCTION vec3 fresnel(vec3 f0, float cosine) {
  precise float left = 1.0f - min(cosine, 1.0f);
  precise float left2 = left * left;
  precise float left5 = left2 * left2 * left;
  precise vec3 f = f0 + (vec3(1.0f) - f0) * left5;
  return f;
}
#endif
