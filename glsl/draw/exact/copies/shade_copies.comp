// Shades mesh copies tile by tile. Each triangle in a pixel is shaded once: at the pixel's centre if the triangle
// covers it, else at the first sample that shows the triangle. Defines: SAMPLES, SHADOW (with SHADOW_TAPS), OCCLUSION,
// REFLECTED, RAYS, EDGES (draws the edges of triangles), and the defines of draw/surface/lighting.glsl.
#define EXACT_PICTURE
#include "common/once.glsl"
#include "draw/exact/tiles/lit_tile.glsl"
#include "draw/exact/copies/copy_source.glsl"
#include "draw/exact/copies/copy_place.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/weights.glsl"
#include "draw/instances/instance_list.glsl"
#include "draw/exact/occlusion/openness_read.glsl"
#include "draw/exact/reflections/reflections_read.glsl"
#include "draw/surface/lighting.glsl"
#include "draw/exact/haze.glsl"
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif
#ifdef RAYS
#include "draw/exact/rays/spots.glsl"
#include "draw/exact/rays/rounded_place.glsl"
#endif
uniform vec3 material;  // material values: roughness, metallic, translucency
vec3 material_ = once(material);

vec4 lightOf(ivec2 pixel, uint number, int sampleAt) {
  int slot = int(number / triangles_);
  Copy copy = copyOf(slot);
  ivec3 corners = cornersOf(number % triangles_);
  vec3 a = onPicture(pointOf(copy, corners.x)), b = onPicture(pointOf(copy, corners.y));
  vec3 c = onPicture(pointOf(copy, corners.z));
  vec2 place = shadingPlace(pixel, -1);
  Weights weights = weightsAt(a, b, c, place);
  if (!weights.within) {
    place = shadingPlace(pixel, sampleAt);
    weights = weightsAt(a, b, c, place);
  }
  vec3 w = weights.of;
  precise float depth = w.x * a.z + w.y * b.z + w.z * c.z;
  vec3 ray = rayThrough(place);
  vec3 p = placeOnRay(ray, depth);
  precise vec3 mean = w.x * normalOf(copy, corners.x) + w.y * normalOf(copy, corners.y) + w.z * normalOf(copy, corners.z);
  vec3 normal = unitOf(mean);
  normal = weights.turned ? -normal : normal;  // flips the normal on back sides, which an open mesh may show
#ifdef RAYS
  vec3 ca = pointOf(copy, corners.x), cb = pointOf(copy, corners.y), cc = pointOf(copy, corners.z);
  precise vec3 first = cb - ca;
  precise vec3 second = cc - ca;
  vec3 across = exactCross(first, second);
  float square = exactDot(across, across);
  precise vec3 facing = square < 1e-30f ? normal : across * exactInverseSqrt(square);
  facing = exactDot(facing, directionOf(ray)) > 0.0f ? -facing : facing;
  bool turned_ = exactDot(normal, facing) < 0.0f;
  vec3 na = unitOf(normalOf(copy, corners.x)), nb = unitOf(normalOf(copy, corners.y)), nc = unitOf(normalOf(copy, corners.z));
  bool away = turned_ != weights.turned;
  vec3 lifted = roundedPlace(p, ca, cb, cc, away ? -na : na, away ? -nb : nb, away ? -nc : nc, w);
  vec3 color = tintOf(texelFetch(positions, slot), texelFetch(velocities, slot));
  precise vec3 moved = lifted - p;
  keepSpot(firstSample(pixel) + sampleAt, lifted, facing, turned_ ? -normal : normal, color, material_, 1.0f, 0u, facing, exactDot(moved, facing));
#ifdef HAZE
  return vec4(throughHaze(vec3(0.0f), 1.0f, lifted), 1.0f);
#else
  return vec4(0.0f, 0.0f, 0.0f, 1.0f);
#endif
#endif
#if defined SHADOW && !defined REFLECTED
  float fraction = sunFractionOn(p, normal);
#else
  const float fraction = 1.0f;
#endif
#if defined LAMPS && !defined REFLECTED
#if SHADOWED_LAMPS > 0
  receivingPlane = normal;
#endif
#endif
  precise vec3 towards = -directionOf(ray);
  vec3 tint = tintOf(texelFetch(positions, slot), texelFetch(velocities, slot));
  Look look = Look(tint, material_.x, material_.y, material_.z, opennessOn(pixel, p));
#ifdef EDGES
  precise vec2 across = place + vec2(1, 0);
  precise vec2 up = place + vec2(0, -1);
  look.base = edgedColor(look.base, w, ofSumOne(weightsAround(a, b, c, across)), ofSumOne(weightsAround(a, b, c, up)));
#endif
#ifdef REFLECTED
  facing_ = normal;
  for (int i = 0; i < 2; ++i) {
    precise vec2 there = place + vec2(i == 0 ? 2.0f : 0.0f, i == 0 ? 0.0f : 2.0f);
    vec3 v = ofSumOne(weightsAround(a, b, c, there));
    precise vec3 next = v.x * normalOf(copy, corners.x) + v.y * normalOf(copy, corners.y) + v.z * normalOf(copy, corners.z);
    vec3 nextNormal = unitOf(next);
    precise vec3 turned = (weights.turned ? -nextNormal : nextNormal) - normal;
    turns_ = max(turns_, exactSqrt(exactDot(turned, turned)));
  }
  const float alpha = 0.0f;
#else
  const float alpha = 1.0f;
#endif
  vec3 light = allLight(look, p, normal, unitOf(towards), fraction);
#ifdef HAZE
  light = throughHaze(light, alpha, p);
#endif
  return vec4(light, alpha);
}

#ifdef REFLECTED
uint partOfThing(uint number) {
  return (number - firstId_) / triangles_;
}
#endif

void main() {
  lightTile(firstId_, uint(capacity_) * triangles_);
}
