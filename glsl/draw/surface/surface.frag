// Metal/rough surface under sun and sky. Variants: TEXTURED, DOUBLE_SIDED, TRANSLUCENT, REFLECTIVE, SHADOW, SKIN (with
// SKIN_UV or TRIPLANAR, and LOOK_ one of skin.glsl).
#include "draw/fragment_frame.glsl"
#include "draw/surface/lighting.glsl"
in vec3 worldPosition;
in vec3 worldNormal;
#ifdef SHADOW
in vec3 place;
#else
const vec3 place = vec3(0);
#endif
#ifdef TEXTURED
in vec2 uv;
layout(binding = albedoUnit) uniform sampler2D albedo;
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
layout(location = 0) out vec4 radiance;

void main() {
  vec3 base = color;
#ifdef TEXTURED
  base *= texture(albedo, uv).rgb;
#endif
  vec3 normal = normalize(worldNormal);
#ifdef DOUBLE_SIDED
  normal = gl_FrontFacing ? normal : -normal;
#endif
  vec3 view = normalize(frame.eye.xyz - worldPosition);
#ifdef SKIN
  Skin skin = skinOnSurface(normal);
  roughness = skin.roughness;
  openness = skin.openness;
  radiance = vec4(surfaceLight(skin.albedo, normal, view, sunFraction(place)) + skin.emission, 1.0);
#else
  radiance = vec4(surfaceLight(base, normal, view, sunFraction(place)), 1.0);
#endif
}
