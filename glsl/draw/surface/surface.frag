// Shades a metal/rough surface. Defines: SHADOW, PALETTE, TEXTURED (with TRIPLANAR, BUMPED), DOUBLE_SIDED, SKIN (with
// SKIN_UV or TRIPLANAR, and one LOOK_ define of skin_look.glsl), and the defines of lighting.glsl.
#include "draw/fragment_frame.glsl"
#include "draw/surface/material.glsl"
#include "draw/surface/shadow_read.glsl"
in vec3 worldPosition;
in vec3 worldNormal;
#ifdef SHADOW
in vec3 place;
#else
const vec3 place = vec3(0);
#endif
#ifdef TRIPLANAR
in vec3 objectPosition;  // position of the surface point in object space (m)
in vec3 objectNormal;
#include "draw/surface/three_sides.glsl"
#endif
#ifdef TEXTURED
#include "draw/surface/texture.glsl"
#endif
#ifdef SKIN
#include "draw/surface/skin_surface.glsl"
#endif
#ifdef PASSED_FRAME
flat in vec3 passedColor;
vec3 color = passedColor;
#else
uniform vec3 color;
#endif
#ifdef BUMPED
#ifdef PASSED_FRAME
float bump = passedMaterial.w;
#else
uniform float bump;  // height of white in the bump texture (m)
#endif
#endif
#ifdef PALETTE
in vec3 paletteColor;
#endif
#ifdef VERTEX_COLORS
in vec3 vertexTint;
#endif
layout(location = 0) out vec4 radiance;

void main() {
#ifdef PALETTE
  vec3 base = paletteColor;
#else
  vec3 base = color;
#endif
#ifdef VERTEX_COLORS
  base *= vertexTint;
#endif
#ifdef TEXTURED
  base *= textureColor(vec2(0));
#endif
  vec3 normal = normalize(worldNormal);
#ifdef DOUBLE_SIDED
  normal = gl_FrontFacing ? normal : -normal;
#endif
#ifdef BUMPED
  normal = bumpedNormal(normal, worldPosition, bump);
#endif
  vec3 view = normalize(frame.eye.xyz - frame.eye.w * worldPosition);
  Look look = lookOf(base);
  vec3 emission = vec3(0);
#ifdef SKIN
  Skin skin = skinOnSurface(normal);
  look.base = skin.albedo;
  look.roughness = skin.roughness;
  look.openness = skin.openness;
  emission = skin.emission;
#endif
  radiance = vec4(allLight(look, worldPosition, normal, view, sunFraction(place)) + emission, 1.0);
}
