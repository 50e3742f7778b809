// Materials generated from a simulation field ("skins"), with the driver's texture filtering. Used on surfaces and for
// baked maps.
#include "draw/bindings.glsl"
layout(binding = reliefUnit) uniform sampler2D relief;  // texture of skin_relief.comp: q (value minus threshold), q^2,
                                                        // slopes of q along u and v per cell
// Texture with the mean of q in a ring around each texel.
layout(binding = surroundingsUnit) uniform sampler2D surroundings;
#ifdef LOOK_MAP
layout(binding = skinColorUnit) uniform sampler2D skinColors;
#endif
#include "draw/surface/skin_values.glsl"
#include "draw/surface/skin_look.glsl"

SkinArea skinArea(vec2 uv) {
  SkinArea area;
  vec2 size = vec2(textureSize(relief, 0));
  vec2 across = dFdx(uv) * size, down = dFdy(uv) * size;
  float level = 0.5 * log2(max(max(dot(across, across), dot(down, down)), 1e-12));
  vec4 mean = texture(relief, uv);
  area.q = mean.x;
  // Pixels smaller than a texel have no variance, because q is only interpolated there.
  area.variance = max(mean.y - mean.x * mean.x, 0.0) * clamp(level, 0.0, 1.0);
  area.slope = mean.zw;
  area.around = texture(surroundings, uv).x;
#ifdef LOOK_MAP
  area.color = texture(skinColors, uv).rgb;
#else
  area.color = vec3(0);
#endif
  return area;
}

Skin skinOf(SkinArea area) {
  vec2 change = vec2(dFdx(area.q), dFdy(area.q));
  return skinOf(area, dot(change, change));
}
