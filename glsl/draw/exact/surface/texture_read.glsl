// Reads a material's texture with filtering in shader code, from a list of texels
// (src/draw/exact/surface/texel_lists.hpp), because software drivers read buffers several times as fast as 2D textures.
// Each entry holds a texel and its right neighbour.
#include "common/once.glsl"
#include "draw/bindings.glsl"
#include "draw/surface/footprint.glsl"
layout(binding = albedoUnit) uniform usamplerBuffer albedo;
uniform ivec2 albedoSize;
ivec2 albedoSize_ = once(albedoSize);
uniform int albedoLevels;
int albedoLevels_ = once(albedoLevels);
uniform bool albedoRepeats;
bool albedoRepeats_ = once(albedoRepeats);

// Converts components in units of 1/65535 to linear light.
vec3 albedoLight(uint rg, uint b) {
  precise vec3 light = vec3(rg & 0xffffu, rg >> 16, b) * 1.5259022e-5f;
  return light;
}

// Reads with bilinear filtering, for FILTERED of footprint.glsl. `first` is the index of the level's first texel.
vec3 albedoBetween(vec2 uv, int level, int first, TextureShape shape) {
  Around around = texelsAround(uv, level, shape);
  ivec4 t = around.texels;
  int width = max(shape.size.x >> level, 1);
  uvec4 up = texelFetch(albedo, first + t.y * width + t.x), down = texelFetch(albedo, first + t.w * width + t.x);
  bool alone = t.x == t.z;  // true at a clamped border, where the two texels are the same
  vec3 p = albedoLight(up.x, up.y), r = albedoLight(down.x, down.y);
  vec3 q = alone ? p : albedoLight(up.z, up.w), s = alone ? r : albedoLight(down.z, down.w);
  precise vec3 upper = p + (q - p) * around.part.x;
  precise vec3 lower = r + (s - r) * around.part.x;
  precise vec3 between = upper + (lower - upper) * around.part.y;
  return between;
}

vec3 albedoAt(vec2 uv, Footprint print, TextureShape shape) {
  int next = min(print.level + 1, shape.levels - 1);
  int first = int(texelFetch(albedo, print.level).x), firstOfNext = int(texelFetch(albedo, next).x);
  precise vec3 sum = vec3(0);
  for (int i = 0; i < print.taps; ++i) {
    precise float aside = (float(i) + 0.5f) * perTap(print.taps) - 0.5f;
    precise vec2 at = uv + print.along * aside;
    vec3 fine = albedoBetween(at, print.level, first, shape), coarse = fine;
    if (print.part > 0.0f) coarse = albedoBetween(at, next, firstOfNext, shape);
    sum = sum + (fine + (coarse - fine) * print.part);
  }
  precise vec3 mean = sum * perTap(print.taps);
  return mean;
}

TextureShape albedoShape() {
  return TextureShape(albedoSize_, albedoLevels_, ivec2(albedoRepeats_ ? WRAP_REPEAT : WRAP_CLAMP));
}

float texelsAPixel(Seen seen) {
  return footprintOf(seen, albedoShape()).longer;
}

// Returns the texture's colour. `shift` is the offset in pixels to the right and up.
vec3 textureSeen(Seen seen, vec2 shift) {
  precise vec2 uv = seen.at + seen.across * shift.x + seen.up * shift.y;
  return albedoAt(uv, footprintOf(seen, albedoShape()), albedoShape());
}
