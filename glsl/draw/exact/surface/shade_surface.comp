// Light of one surface on its tiles: each primitive of a pixel once, in the pixel's middle if that is on it, else at the
// first of its samples. JOINED: of several surfaces that have nothing laid over them. Variants: those of draw/surface/lighting.glsl,
// SHADOW (with SHADOW_TAPS), OCCLUSION, RAYS, PALETTE, DOUBLE_SIDED, TEXTURED (BUMPED) or SKIN (LOOK_ one of draw/surface/skin_look.glsl), by uv, of
// a GRID or a mesh, or TRIPLANAR. SAMPLES.
#define EXACT_PICTURE
#include "common/once.glsl"
#ifdef JOINED
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/owners.glsl"
layout(binding = lookUnit) uniform samplerBuffer looks;
bool mirrors = false, bothSides = false;  // of the surface that is being shaded, as are color_ and material_
#endif
#include "draw/exact/tiles/lit_tile.glsl"
#include "draw/exact/triangles/surface_triangle.glsl"
#include "draw/exact/surface/surface_spot.glsl"
#include "draw/exact/occlusion/openness_read.glsl"
#include "draw/surface/lighting.glsl"
#if defined TEXTURED || defined SKIN
#include "draw/exact/surface/surface_seen.glsl"
#endif
#ifdef TEXTURED
#include "draw/exact/surface/surface_texture.glsl"
#endif
#ifdef SKIN
#include "draw/exact/surface/surface_skin.glsl"
#endif
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif
#ifdef RAYS
#include "draw/exact/rays/surface_spots.glsl"
#endif
uniform uint firstId;
uint firstId_ = once(firstId);
#ifdef JOINED
vec3 color_ = vec3(0), material_ = vec3(0);
void takeLook(uint number) {
  int owner = ownerOf(number);
  vec4 first = texelFetch(looks, 2 * owner);
  color_ = first.rgb;
  mirrors = first.a > 0.0f;
  material_ = texelFetch(looks, 2 * owner + 1).xyz;
  bothSides = showsBothSides(number);
}
#else
const bool bothSides = true;
uniform vec3 color;
vec3 color_ = once(color);
uniform vec3 material;  // roughness, metallic, translucency
vec3 material_ = once(material);
#endif

vec4 lightOf(ivec2 pixel, uint triangle, int sampleAt) {
#ifdef JOINED
  triangle += firstId_;
  takeLook(triangle);
#endif
  Spot spot = spotOf(cornersOf(int(triangle)), pixel, sampleAt);
  precise vec3 base = color_;
#ifdef PALETTE
  base = paletteColor(spot);
#endif
  vec3 normal = spot.normal;
#ifdef DOUBLE_SIDED
  normal = spot.turned && bothSides ? -normal : normal;
#endif
#ifdef TEXTURED
  Patch patch_ = patchSeen(surfaceSeen(spot));
  base = base * patch_.color;
#ifdef BUMPED
  normal = bumpedNormal(patch_, spot, normal);
#endif
#endif
#ifdef SHADOW
  float fraction = sunFractionOn(spot.place, spot.normal);
#else
  const float fraction = 1.0f;
#endif
  Look look = Look(base, material_.x, material_.y, material_.z, opennessOn(pixel, spot.place));
  precise vec3 light = vec3(0);
#ifdef SKIN
  SpotSkin found = skinOn(spot, normal);
  normal = found.normal;
  look.base = found.skin.albedo;
  look.roughness = found.skin.roughness;
  precise float open = look.openness * found.skin.openness;
  look.openness = open;
  light = found.skin.emission;
#endif
#ifdef RAYS
  keepSurfaceSpot(spot, look, normal, firstSample(pixel) + sampleAt);
#else
  light = light + allLight(look, spot.place, normal, spot.view, fraction);
#endif
  return vec4(light, 1.0f);
}

void main() {
  lightTile(firstId_, uint(trianglesToDraw()));
}
