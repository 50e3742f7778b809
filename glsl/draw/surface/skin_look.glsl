// Appearance of a skin, computed from the local values of its field. LOOK_LEATHER, LOOK_SPOTS, LOOK_CRACKS and LOOK_MAP
// select the look. LOOK_ANY: skinLook_ holds the index of the look in this order. The including file declares the
// skin's threshold, colours, roughness and depth.  Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"
#include "draw/surface/rise.glsl"

// Field values over the footprint of a pixel.
struct SkinArea {
  float q;         // mean of q = field value - threshold
  float variance;  // variance of q over the pixel
  float around;    // mean of q in a ring around the point
  vec2 slope;      // slope of q along u and v, per cell
  vec3 color;
};

struct Skin {
  vec3 albedo;
  vec3 emission;  // emitted radiance
  float roughness;
  float height;    // height of the relief, 0 to 1
  float openness;  // fraction of ambient light that reaches the point
};

// Returns the skin's material. A value spread evenly over a width w has the variance w^2 / 12 and is above 0 for the
// fraction clamp(q / w + 1/2). One width therefore serves both for edges (change of q over a pixel) and for patterns
// smaller than a pixel (variance). `change2` is the squared change of q over a pixel.
FUNCTION Skin skinOf(SkinArea area, float change2) {
  ROUNDED float width2 = change2 + 12.0f * area.variance + 1e-8f;
  ROUNDED float share = area.q * inverseRoot(width2) + 0.5f;
  float cover = clamp(share, 0.0f, 1.0f);
  ROUNDED float above = area.q + skinThreshold;
  float fraction = clamp(above, 0.0f, 1.0f);
  ROUNDED float below = 1.0f - fraction;
  ROUNDED float sunken = skinDepth * (area.around - area.q);
  ROUNDED float closed = 1.0f + 0.4f * max(sunken, 0.0f);
  Skin skin;
  skin.emission = vec3(0);
  skin.roughness = skinRoughness;
  skin.height = skinDepth < 0.0f ? below : fraction;
  skin.openness = inverse(closed);
#if defined LOOK_LEATHER || defined LOOK_SPOTS
  skin.albedo = blend(skinLow, skinHigh, cover);
#elif defined LOOK_CRACKS || defined LOOK_ANY
  ROUNDED float span = 1.0f - skinThreshold;
  ROUNDED float heat = area.q * inverse(max(span, 0.05f));
  ROUNDED vec3 cold = skinLow * (1.0f - cover);
  ROUNDED vec3 glow = skinHigh * (cover * (0.3f + 0.7f * smoothed(clamp(heat, 0.0f, 1.0f))));
  skin.albedo = cold;
  skin.emission = glow;
#ifdef LOOK_ANY
  skin.emission = skinLook_ == 2 ? glow : vec3(0);
  skin.albedo = skinLook_ == 3 ? area.color : skinLook_ == 2 ? cold : blend(skinLow, skinHigh, cover);
#endif
#else
  skin.albedo = area.color;
#endif
  return skin;
}
