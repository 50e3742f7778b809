// Metal/rough surface under sun and sky. Variants: TEXTURED, DOUBLE_SIDED, TRANSLUCENT, REFLECTIVE, SHADOW.
#include "draw/frame_block.glsl"
#include "draw/sky.glsl"
#include "draw/shading.glsl"
#include "draw/shadow_read.glsl"
in vec3 worldPosition;
in vec3 worldNormal;
#ifdef SHADOW
in vec3 place;
#else
const vec3 place = vec3(0);
#endif
#ifdef TEXTURED
in vec2 uv;
layout(binding = 3) uniform sampler2D albedo;
#endif
uniform vec3 color;
uniform float roughness;
uniform float metallic;
uniform float translucency;
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
  vec3 sun = frame.sunDirection.xyz;
  float nl = dot(normal, sun);
  float share = sunShare(place);
  float lit = max(nl, 0.0) * share;
#ifdef REFLECTIVE
  vec3 matt = base * (1.0 - metallic);
  vec3 mirror = mix(vec3(0.04), base, metallic);
#else
  vec3 matt = base;
  vec3 mirror = vec3(0.04);
#endif
  float lobe = sunLobe(normal, view, sun, roughness) * lit;
#ifdef TRANSLUCENT
  float direct = mix(lit, max(-nl, 0.0) * share, translucency);
  vec3 ambient = mix(ambientLight(normal.y), ambientLight(-normal.y), translucency);
#else
  float direct = lit;
  vec3 ambient = ambientLight(normal.y);
#endif
  vec3 light = matt * (frame.sunLight.rgb * direct + ambient) + mirror * (frame.sunLight.rgb * lobe);
#ifdef REFLECTIVE
  float nv = abs(dot(normal, view));
  float height = 2.0 * dot(normal, view) * normal.y - view.y;  // of the mirrored direction
  vec2 weight = ambientLobe(roughness, nv);
  light += (mirror * weight.x + weight.y) * mix(skyRadiance(height), ambientLight(height), roughness);
#endif
  radiance = vec4(light, 1.0);
}
