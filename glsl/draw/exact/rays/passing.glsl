// Triangles through which rays may pass: holes, blended surfaces and, for shadow rays (ANY_HIT), clear surfaces.
// Included only with PASSAGES. LAID: the colour map is also read, at the hit's uv.
#include "draw/exact/rays/met_triangle.glsl"
#include "draw/exact/rays/dielectric.glsl"
#include "draw/surface/shading.glsl"
#include "draw/exact/unit_vector.glsl"
#include "common/hash.glsl"
#ifdef LAID
#include "draw/exact/rays/lays.glsl"
#endif
#ifdef ANY_HIT
vec3 passed_ = vec3(1), depths_ = vec3(0);  // fraction of light that is transmitted, and path lengths inside solids
                                            // times absorption

vec3 lightPassed() {
  precise vec3 light = passed_ * vec3(exactExp(-max(depths_.x, 0.0f)), exactExp(-max(depths_.y, 0.0f)), exactExp(-max(depths_.z, 0.0f)));
  return light;
}
#endif

vec4 colorPassed(ivec3 vertices, int owner, vec2 weight) {
  vec4 color = vec4(1);
#ifdef LAID
  ivec4 map = ivec4(lookWords(owner, colorMapLook));
  vec4 how = lookOf(owner, laidLook);
  if (map.x > 0 && how.w <= 0.0f) {
    vec2 a = texelFetch(lays, vertices.x).xy, b = texelFetch(lays, vertices.y).xy, c = texelFetch(lays, vertices.z).xy;
    precise float rest = 1.0f - weight.x - weight.y;
    precise vec2 uv = (a * rest + b * weight.x + c * weight.y) * how.xy;
    color = mapAt(Seen(uv, vec2(0), vec2(0)), map);
  }
#endif
  return color;
}

#ifdef ANY_HIT
// A shadow ray exactly through a common edge hits both triangles, but only one may attenuate it. This is the triangle
// for which the edge, seen along the ray, runs upwards.
bool ownsUp(float weight, vec3 from, vec3 to, bool turned) {
  bool up = to.y > from.y || (to.y == from.y && to.x > from.x), down = to.y < from.y || (to.y == from.y && to.x < from.x);
  return weight != 0.0f || (turned ? down : up);
}
bool ownsPlace(Ray ray, int at) {
  vec3 u = alongRay(ray, metPlace(at, 0)), v = alongRay(ray, metPlace(at, 1)), w = alongRay(ray, metPlace(at, 2));
  precise float wa = v.x * w.y - v.y * w.x;
  precise float wb = w.x * u.y - w.y * u.x;
  precise float wc = u.x * v.y - u.y * v.x;
  precise float sum = wa + wb + wc;
  bool turned = sum < 0.0f;
  return ownsUp(wa, v, w, turned) && ownsUp(wb, w, u, turned) && ownsUp(wc, u, v, turned);
}

// Attenuates a shadow ray at a clear surface. The ray goes straight on without refraction. The fraction that the
// surface reflects, computed for light from outside, is lost.
void passGlass(Ray ray, int at, ivec3 vertices, int owner, vec2 weight, float t, vec3 tint, float share) {
  vec3 a = metPlace(at, 0);
  precise vec3 first = metPlace(at, 1) - a;
  precise vec3 second = metPlace(at, 2) - a;
  vec3 across = exactCross(first, second);
  vec3 n = unpackedUnit(texelFetch(vertexWords, vertices.x).x);
  bool leaves = (exactDot(across, ray.along) > 0.0f) == (exactDot(across, n) > 0.0f);
  float cosine = abs(exactDot(across, ray.along));
  precise float unit_ = cosine * exactInverseSqrt(max(exactDot(across, across), 1e-30f));
  vec4 glass = lookOf(owner, glassLook);
  bool thin = glass.y > 0.0f;
  float once_ = dielectricFresnel(min(unit_, 1.0f), exactReciprocal(glass.x));
  precise float all_ = 1.0f + once_;
  precise float both = 2.0f * once_ * exactReciprocal(all_);
  vec3 own = thin ? tint : vec3(exactSqrt(tint.x), exactSqrt(tint.y), exactSqrt(tint.z));
  // Fraction of light that the coat's lobe reflects (finished_facet.glsl).
  vec2 coated_ = ambientLobe(lookOf(owner, layerLook).x, clamp(unit_, 1e-3f, 1.0f));
  precise float taken = lookOf(owner, lightLook).w * (0.04f * coated_.x + coated_.y);
  precise float left = 1.0f - clamp(taken, 0.0f, 1.0f);
  precise vec3 passed = passed_ * own * (share * (1.0f - (thin ? both : once_))) * left;
  passed_ = passed;
  precise vec3 depths = depths_ + lookOf(owner, absorbLook).xyz * (leaves ? t : -t);
  depths_ = thin ? depths_ : depths;
}
#endif

// Returns `best` if the ray passes through the hit, otherwise `hit`.
RayHit hitOrPassed(Ray ray, RayHit hit, RayHit best) {
  ivec3 vertices = metCorners(hit.at);
  int owner = ownerOf(vertices);
  vec4 layers = lookOf(owner, layerLook);
  vec4 color = colorPassed(vertices, owner, hit.weight);
  precise float opacity = layers.z * color.a;
  if (layers.w > 0.0f && opacity < layers.w) return best;
#ifdef ANY_HIT
  bool owns = ownsPlace(ray, hit.at);
  if (layers.w < 0.0f) {
    if (!owns) return best;
    precise vec3 left = passed_ * (1.0f - opacity);
    passed_ = left;
    return opacity < 1.0f ? best : hit;
  }
  precise float share = lookOf(owner, sheenLook).w * (1.0f - lookOf(owner, fallbackMaterial).y);
  if (share <= 0.0f) return hit;
  if (!owns) return best;
  uvec4 words = texelFetch(vertexWords, vertices.x);
  precise vec3 tint = vec3(unpackHalf2x16(words.y), unpackHalf2x16(words.z).x) * color.rgb;
  passGlass(ray, hit.at, vertices, owner, hit.weight, hit.t, tint, share);
  return best;
#else
  if (layers.w >= 0.0f) return hit;
  // A ray hits a blended surface with a probability equal to the opacity.
  uvec3 mixed = hash3(floatBitsToUint(ray.along) ^ floatBitsToUint(ray.origin) ^ uvec3(uint(hit.at), 0u, 0u));
  precise float u = float(int(mixed.x >> 8)) * 5.9604645e-8f;
  return u < opacity ? hit : best;
#endif
}
