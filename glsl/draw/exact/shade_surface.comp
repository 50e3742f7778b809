// Light of one surface on its tiles: each primitive of a pixel once, in the pixel's middle if that is on it, else at the
// first of its samples. Variants: those of draw/surface/lighting.glsl, SHADOW (with SHADOW_TAPS), PALETTE, DOUBLE_SIDED.
// SAMPLES.
#define EXACT_PICTURE
#include "draw/exact/shaded_tile.glsl"
#include "draw/exact/surface_triangle.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/weights.glsl"
#include "draw/exact/unit_vector.glsl"
#include "draw/surface/lighting.glsl"
#ifdef SHADOW
#include "draw/exact/sun_map.glsl"
#endif
#ifdef PALETTE
layout(binding = positionUnit) uniform samplerBuffer positions;
layout(binding = paletteUnit) uniform samplerBuffer palette;
#endif
uniform uint firstId;
uniform vec3 color;
uniform vec3 material;  // roughness, metallic, translucency

#ifdef PALETTE
vec3 paletteColor(int vertex) {
  return texelFetch(palette, int(texelFetch(positions, vertex - firstVertex).w)).rgb;
}
#endif

vec3 lightOf(ivec2 pixel, uint id, int firstSample) {
  ivec3 corners = cornersOf(int(id - firstId));
  uvec4 a = texelFetch(vertices, corners.x), b = texelFetch(vertices, corners.y), c = texelFetch(vertices, corners.z);
  vec2 place = shadingPlace(pixel, -1);
  Weights weights = weightsAt(placeOf(a), placeOf(b), placeOf(c), place);
  if (!weights.within) {
    place = shadingPlace(pixel, firstSample);
    weights = weightsAt(placeOf(a), placeOf(b), placeOf(c), place);
  }
  vec3 w = weights.of;
  precise float depth = w.x * uintBitsToFloat(a.z) + w.y * uintBitsToFloat(b.z) + w.z * uintBitsToFloat(c.z);
  vec3 ray = rayThrough(place);
  vec3 p = placeOnRay(ray, depth);
  precise vec3 mean = w.x * unpackedUnit(a.w) + w.y * unpackedUnit(b.w) + w.z * unpackedUnit(c.w);
  vec3 normal = unitOf(mean);
#ifdef DOUBLE_SIDED
  normal = weights.turned ? -normal : normal;
#endif
#ifdef PALETTE
  precise vec3 base = w.x * paletteColor(corners.x) + w.y * paletteColor(corners.y) + w.z * paletteColor(corners.z);
#else
  vec3 base = color;
#endif
#ifdef SHADOW
  float fraction = sunFractionOn(p, normal);
#else
  const float fraction = 1.0f;
#endif
  precise vec3 towards = -ray;
  return allLight(Look(base, material.x, material.y, material.z, 1.0f), p, normal, unitOf(towards), fraction);
}

void main() {
  ivec2 pixel = pixelToShade();
  if (pixel.x < 0) return;
  uint shown[SAMPLES];
  int left = 0;
  int triangles = trianglesToDraw();
  for (int s = 0; s < SAMPLES; ++s) {
    shown[s] = idAt(pixel, s);
    if (shown[s] >= firstId && shown[s] - firstId < uint(triangles)) left |= 1 << s;
  }
  while (left != 0) {
    int first = findLSB(left);
    uint id = idAt(pixel, first);
    int same = 0;
    for (int s = 0; s < SAMPLES; ++s)
      if (shown[s] == id) same |= 1 << s;
    addLight(pixel, vec4(lightOf(pixel, id, first), 1.0f), bitCount(same));
    left &= ~same;
  }
}
