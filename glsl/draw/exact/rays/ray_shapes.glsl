// Intersection of rays with triangles and balls. Compiles as GLSL and as C++.
// The corners of a triangle are transformed to ray coordinates (two across the ray, one along it). Three products of
// the coordinates tell on which side of each edge the ray passes. Two triangles with a common edge get the same product
// with opposite sign. Therefore no ray slips through between them, and a ray exactly through the edge hits both. A
// triangle seen edge-on (sum of the products about zero) is not hit. Of several hits at the same distance, the first
// one in the hierarchy's order counts.
#ifndef EXACT_RAY_SHAPES
#define EXACT_RAY_SHAPES
#include "draw/exact/rays/ray_box.glsl"

struct Ray {
  vec3 origin;  // origin of the ray in metres
  vec3 along;   // unit direction of the ray
  vec3 right;   // unit vectors perpendicular to the ray's direction
  vec3 up;
};

struct RayHit {
  float t;   // distance of the hit along the ray in metres
  int at;    // index of the hit object in the hierarchy's order; -1 if there is no hit
  vec2 weight;  // barycentric weights of the triangle's second and third corner
};

// These functions return unit vectors perpendicular to a unit vector n (Duff et al., "Building an Orthonormal Basis,
// Revisited", JCGT 6(1), 2017).
FUNCTION vec3 rightOf(vec3 n) {
  float side = n.z < 0.0f ? -1.0f : 1.0f;
  precise float sum = side + n.z;
  precise float a = -exactReciprocal(sum);
  precise vec3 right = vec3(1.0f + side * n.x * n.x * a, side * n.x * n.y * a, -side * n.x);
  return right;
}
FUNCTION vec3 upOf(vec3 n) {
  float side = n.z < 0.0f ? -1.0f : 1.0f;
  precise float sum = side + n.z;
  precise float a = -exactReciprocal(sum);
  precise vec3 up = vec3(n.x * n.y * a, side + n.y * n.y * a, -n.y);
  return up;
}

FUNCTION Ray rayOf(vec3 origin, vec3 along) {
  Ray ray;
  ray.origin = origin;
  ray.along = along;
  ray.right = rightOf(along);
  ray.up = upOf(along);
  return ray;
}

FUNCTION vec3 alongRay(Ray ray, vec3 p) {
  precise vec3 from = p - ray.origin;
  return vec3(exactDot(ray.right, from), exactDot(ray.up, from), exactDot(ray.along, from));
}

// Returns the hit of a triangle if it is nearer than `best`, otherwise `best`. `span` holds the distances at which the
// ray enters and leaves the triangle's box.
FUNCTION RayHit nearerTriangle(Ray ray, vec3 a, vec3 b, vec3 c, vec2 span, int at, RayHit best) {
  vec3 u = alongRay(ray, a), v = alongRay(ray, b), w = alongRay(ray, c);
  precise float wa = v.x * w.y - v.y * w.x;
  precise float wb = w.x * u.y - w.y * u.x;
  precise float wc = u.x * v.y - u.y * v.x;
  precise float sum = wa + wb + wc;
  bool left = wa >= 0.0f && wb >= 0.0f && wc >= 0.0f, right = wa <= 0.0f && wb <= 0.0f && wc <= 0.0f;
  bool met = (left || right) && abs(sum) > 1e-28f && isWithin(span.x, span.y);
  float per = exactReciprocal(met ? sum : 1.0f);
  precise vec3 part = vec3(wa, wb, wc) * per;
  precise float distance_ = part.x * u.z + part.y * v.z + part.z * w.z;
  float t = distance_ > span.x ? distance_ : span.x;
  met = met && distance_ > 0.0f && (t < best.t || (t == best.t && at < best.at));
  RayHit hit = best;
  hit.t = met ? t : best.t;
  hit.at = met ? at : best.at;
  hit.weight = met ? vec2(part.y, part.z) : best.weight;
  return hit;
}

// Returns the hit of a ball if it is nearer than `best`, otherwise `best`. The hit is the point where the ray enters
// the ball, or leaves it if the ray starts inside.
FUNCTION RayHit nearerBall(Ray ray, vec3 middle, float radius, vec2 span, int at, RayHit best) {
  precise vec3 to = middle - ray.origin;
  float nearest = exactDot(to, ray.along);
  precise vec3 aside = ray.along * nearest - to;
  precise float square = radius * radius - exactDot(aside, aside);
  float half_ = exactSqrt(max(square, 0.0f));
  precise float enters = nearest - half_;
  precise float leaves = nearest + half_;
  float distance_ = enters > 0.0f ? enters : leaves;
  float t = distance_ > span.x ? distance_ : span.x;
  bool met = square > 0.0f && distance_ > 0.0f && isWithin(span.x, span.y) && (t < best.t || (t == best.t && at < best.at));
  RayHit hit = best;
  hit.t = met ? t : best.t;
  hit.at = met ? at : best.at;
  hit.weight = met ? vec2(0.0f) : best.weight;
  return hit;
}
#endif
