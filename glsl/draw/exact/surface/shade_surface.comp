// Shades one surface tile by tile. Each triangle in a pixel is shaded once: at the pixel's centre if the triangle
// covers it, else at the first sample that shows the triangle. JOINED: shades several surfaces without textures.
// Defines: SAMPLES; SHADOW (with SHADOW_TAPS), OCCLUSION, REFLECTED, RAYS, PALETTE, VERTEX_COLORS, DOUBLE_SIDED;
// TEXTURED (BUMPED) or SKIN (with a LOOK_ define of draw/surface/skin_look.glsl), by uv of a GRID or a mesh, or
// TRIPLANAR; EDGES (draws the edges of triangles); maps (surface_maps.glsl), EMISSION, COAT, SHEEN; BLENDED (a blended
// layer); GLASS (a layer of glass, REFRACTED in glass.glsl); and the defines of draw/surface/lighting.glsl. BY_UV: SHOWN
// has a value that is computed from texture coordinates.
#define EXACT_PICTURE
#include "common/once.glsl"
#ifdef JOINED
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/owners.glsl"
layout(binding = lookUnit) uniform samplerBuffer looks;
bool mirrors = false, bothSides = false;  // properties, like color_ and material_, of the surface that is being shaded
#endif
#include "draw/exact/tiles/lit_tile.glsl"
#include "draw/exact/triangles/surface_triangle.glsl"
#include "draw/exact/surface/surface_spot.glsl"
#include "draw/exact/occlusion/openness_read.glsl"
#include "draw/exact/reflections/reflections_read.glsl"
#ifdef SHEEN
uniform vec3 sheen;
vec3 sheen_ = once(sheen);
uniform float sheenRoughness;
float sheenRoughness_ = once(sheenRoughness);
#endif
#include "draw/surface/lighting.glsl"
#include "draw/exact/haze.glsl"
#if defined BASE_MAP || defined NORMAL_MAP || defined METAL_ROUGH_MAP || defined OCCLUSION_MAP || defined EMISSION_MAP
#define MAPPED
#endif
#ifdef BY_UV
#include "draw/surface/footprint.glsl"
#include "draw/exact/surface/surface_uv.glsl"
uniform vec2 textureScale;  // 0: the surface has no texture coordinates
vec2 textureScale_ = once(textureScale);
#endif
#if defined TEXTURED || defined SKIN || defined MAPPED
#include "draw/exact/surface/surface_seen.glsl"
#endif
#ifdef TEXTURED
#include "draw/exact/surface/surface_texture.glsl"
#endif
#ifdef SKIN
#include "draw/exact/surface/surface_skin.glsl"
#endif
#ifdef MAPPED
#include "draw/exact/surface/surface_maps.glsl"
#endif
#ifdef EMISSION
uniform vec3 emission;
vec3 emission_ = once(emission);
#endif
#ifdef COAT
#include "draw/surface/coat.glsl"
uniform vec2 coat;  // coat; x: strength, y: roughness
vec2 coat_ = once(coat);
#endif
#ifdef BLENDED
uniform float opacity;
float opacity_ = once(opacity);
#endif
#ifdef SHADOW
#include "draw/exact/shadows/sun_map.glsl"
#endif
#ifdef RAYS
#include "draw/exact/rays/surface_spots.glsl"
#ifndef JOINED
uniform uint owner;
uint owner_ = once(owner);
uniform bool clear;
bool clear_ = once(clear);
#else
const uint owner_ = 0u;
const bool clear_ = false;
#endif
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
uniform vec3 material;  // material values: roughness, metallic, translucency
vec3 material_ = once(material);
#endif
#ifdef GLASS
#include "draw/exact/surface/glass.glsl"
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
#ifdef VERTEX_COLORS
  base = base * tintOn(spot);
#endif
  vec3 normal = spot.normal;
#ifdef MAPPED
  SurfaceSeen seen = surfaceSeen(spot);
#endif
#ifdef NORMAL_MAP
  Relief relief = reliefOn(seen, spot);
  normal = relief.normal;
#endif
#ifdef DOUBLE_SIDED
  normal = spot.turned && bothSides ? -normal : normal;
#endif
#ifdef BASE_MAP
  vec4 texel = mapOn(seen, colorMap_);
  base = base * texel.rgb;
#endif
#ifdef TEXTURED
  Patch patch_ = patchSeen(surfaceSeen(spot));
  base = base * patch_.color;
#ifdef BUMPED
  normal = bumpedNormal(patch_, spot, normal);
#endif
#endif
#if defined SHADOW && !defined REFLECTED
  float fraction = sunFractionOn(spot.place, spot.normal);
#else
  const float fraction = 1.0f;
#endif
#if defined LAMPS && !defined REFLECTED
#if SHADOWED_LAMPS > 0
  receivingPlane = spot.normal;
#endif
#endif
  Look look = Look(base, material_.x, material_.y, material_.z, opennessOn(pixel, spot.place));
#ifdef EDGES
  look.base = edgedColor(look.base, spot.weight, weightsBeside(spot, vec2(1, 0)), weightsBeside(spot, vec2(0, -1)));
#endif
#ifdef BY_UV
  Seen seen = seenByUv(spot, textureScale_);
#if SHOWN == 3
  return vec4(seen.at, 0.0f, 1.0f);
#else
  // A mesh without coordinates has the same ones at all its vertices.
  bool varies = seen.across != vec2(0) || seen.up != vec2(0);
  look.base = textureScale_.x > 0.0f && varies ? checkerColor(seen.at, seen.across, seen.up) : vec3(0.2f);
#endif
#endif
#ifdef METAL_ROUGH_MAP
  vec4 made = mapOn(seen, metalRoughMap_);
  precise float rough = look.roughness * made.g;
  precise float metal = look.metallic * made.b;
  look.roughness = rough;
  look.metallic = metal;
#endif
#ifdef NORMAL_MAP
  look.roughness = spreadRoughness(look.roughness, relief.mean);
#endif
#ifdef OCCLUSION_MAP
  precise float openThere = look.openness * openOn(seen);
  look.openness = openThere;
#endif
  precise vec3 light = vec3(0);
#ifdef EMISSION
  light = emission_;
#ifdef EMISSION_MAP
  light = light * mapOn(seen, emissionMap_).rgb;
#endif
#endif
#ifdef SKIN
  SpotSkin found = skinOn(spot, normal);
  normal = found.normal;
  look.base = found.skin.albedo;
  look.roughness = found.skin.roughness;
  precise float open = look.openness * found.skin.openness;
  look.openness = open;
  light = found.skin.emission;
#endif
#ifdef GLASS
  precise vec3 clearBase = (1.0f - look.metallic) * look.base;
  precise vec3 matt = look.base - glass_.x * clearBase;
  look.base = matt;
#endif
#ifdef RAYS
  keepSurfaceSpot(spot, look, normal, firstSample(pixel) + sampleAt, owner_, clear_);
#else
#if defined SHOWN || defined REFLECTED
  light = vec3(0);  // the outputs of SHOWN and REFLECTED contain no emission
#endif
#ifdef REFLECTED
  facing_ = spot.turned ? -spot.normal : spot.normal;
  turns_ = turnsOn(spot);
#endif
  light = light + allLight(look, spot.place, normal, spot.view, fraction);
#if defined COAT && !defined SHOWN
#ifdef SHEEN
  vec3 fibres = sheen_;
  sheen_ = vec3(0);  // the coat is above the fibres, so its light contains no fibres
#endif
  vec3 smoothNormal = spot.normal;
#ifdef DOUBLE_SIDED
  smoothNormal = spot.turned && bothSides ? -smoothNormal : smoothNormal;
#endif
  Look film = Look(vec3(0), coat_.y, 0.0f, 0.0f, look.openness);
  vec3 mirrored = allLight(film, spot.place, smoothNormal, spot.view, fraction);
#ifdef SHEEN
  sheen_ = fibres;
#endif
  light = coated(light, mirrored, coat_.x, coat_.y, abs(exactDot(smoothNormal, spot.view)));
#endif
#endif
#if defined HAZE && !defined GLASS
  light = throughHaze(light, 1.0f, spot.place);
#endif
#ifdef BLENDED
  float alpha = opacity_;
#ifdef BASE_MAP
  precise float there = alpha * texel.a;
  alpha = there;
#endif
  return vec4(light, alpha);
#elif defined GLASS
  return throughGlass(light, clearBase, look.roughness, spot, pixel, sampleAt);
#elif defined REFLECTED
  return vec4(light, 0.0f);
#else
  return vec4(light, 1.0f);
#endif
}

#ifdef REFLECTED
uint partOfThing(uint number) {
#ifdef JOINED
  return uint(ownerOf(number));
#else
  return 0u;
#endif
}
#endif

void main() {
  lightTile(firstId_, uint(trianglesToDraw()));
}
