// Materials grown from a field, alike on surfaces and in baked maps. LOOK_LEATHER, LOOK_SPOTS, LOOK_CRACKS, LOOK_MAP.
#include "draw/bindings.glsl"
layout(binding = reliefUnit) uniform sampler2D relief;  // skin_relief.comp: q, q^2, slope along u and v per cell
layout(binding = surroundingsUnit) uniform sampler2D surroundings;  // mean of q around
#ifdef LOOK_MAP
layout(binding = skinColorUnit) uniform sampler2D skinColors;
#endif
uniform float skinThreshold;  // as a fraction of the field's range
uniform vec3 skinLow;
uniform vec3 skinHigh;
uniform float skinRoughness;
uniform float skinDepth;  // height of the whole range in cells; negative: what is high lies low

// What a pixel covers of the field.
struct SkinArea {
  float q;         // mean of what is above the threshold
  float variance;  // of that
  float around;    // mean of a ring around it
  vec2 slope;      // of q along u and v
  vec3 color;
};

SkinArea skinArea(vec2 uv) {
  SkinArea area;
  vec2 size = vec2(textureSize(relief, 0));
  vec2 across = dFdx(uv) * size, down = dFdy(uv) * size;
  float level = 0.5 * log2(max(max(dot(across, across), dot(down, down)), 1e-12));
  vec4 mean = texture(relief, uv);
  area.q = mean.x;
  // Between texels that a pixel does not even fill there is no variance, only interpolation.
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

struct Skin {
  vec3 albedo;
  vec3 emission;  // radiance
  float roughness;
  float height;    // 0 to 1
  float openness;  // fraction of the surroundings' light that gets in
};

// A value spread evenly over a width w has variance w^2 / 12, and clamp(q / w + 1/2) of it lies above 0. So one
// width serves for edges (the change of q over a pixel) and for patterns smaller than pixels (their variance).
Skin skinOf(SkinArea area) {
  vec2 change = vec2(dFdx(area.q), dFdy(area.q));
  float width = sqrt(dot(change, change) + 12.0 * area.variance + 1e-8);
  float cover = clamp(area.q / width + 0.5, 0.0, 1.0);
  float fraction = clamp(area.q + skinThreshold, 0.0, 1.0);
  Skin skin;
  skin.emission = vec3(0);
  skin.roughness = skinRoughness;
  skin.height = skinDepth < 0.0 ? 1.0 - fraction : fraction;
  skin.openness = 1.0 / (1.0 + 0.4 * max(skinDepth * (area.around - area.q), 0.0));
#if defined LOOK_LEATHER
  skin.albedo = mix(skinLow, skinHigh, cover);
#elif defined LOOK_SPOTS
  skin.albedo = mix(skinLow, skinHigh, cover);
#elif defined LOOK_CRACKS
  float heat = clamp(area.q / max(1.0 - skinThreshold, 0.05), 0.0, 1.0);
  skin.albedo = skinLow * (1.0 - cover);
  skin.emission = skinHigh * (cover * (0.3 + 0.7 * heat * heat * (3.0 - 2.0 * heat)));
#else
  skin.albedo = area.color;
#endif
  return skin;
}
