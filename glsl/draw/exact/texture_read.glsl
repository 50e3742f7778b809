// A material's texture by reads of our own. Texels are linear light in 1/65535.
#include "draw/bindings.glsl"
#include "draw/exact/footprint.glsl"
layout(binding = albedoUnit) uniform usampler2D albedo;
uniform ivec2 albedoSize;
uniform int albedoLevels;
uniform bool albedoRepeats;

vec3 albedoTexel(int x, int y, int level) {
  precise vec3 light = vec3(texelFetch(albedo, ivec2(x, y), level).rgb) * 1.5259022e-5f;
  return light;
}
FILTERED(vec3, albedoAt, albedoTexel)

TextureShape albedoShape() {
  return TextureShape(albedoSize, albedoLevels, albedoRepeats);
}

float texelsAPixel(Seen seen) {
  return footprintOf(seen, albedoShape()).longer;
}

// `shift`: seen from so many pixels to the right and up.
vec3 textureSeen(Seen seen, vec2 shift) {
  precise vec2 uv = seen.at + seen.across * shift.x + seen.up * shift.y;
  return albedoAt(uv, footprintOf(seen, albedoShape()), albedoShape());
}
