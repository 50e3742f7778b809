// From light to the numbers of a picture. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Rows of the two matrices around the curve, and the curve, of a fit of the ACES reference rendering and sRGB output
// transforms by Stephen Hill (BakingLab, ToneMapping.hlsl). The factor makes matt white under the default sun come out
// just short of white.
FUNCTION vec3 filmed(vec3 light) {
  ROUNDED vec3 bright = 1.3f * light;
  ROUNDED vec3 v = vec3(0.59719f, 0.07600f, 0.02840f) * bright.x + vec3(0.35458f, 0.90834f, 0.13383f) * bright.y +
                   vec3(0.04823f, 0.01566f, 0.83777f) * bright.z;
  ROUNDED vec3 over = v * (v + 0.0245786f) - 0.000090537f;
  ROUNDED vec3 under = v * (0.983729f * v + 0.4329510f) + 0.238081f;
  ROUNDED vec3 curve = over * vec3(inverse(under.x), inverse(under.y), inverse(under.z));
  ROUNDED vec3 shown = vec3(1.60475f, -0.10208f, -0.00327f) * curve.x + vec3(-0.53108f, 1.10813f, -0.07276f) * curve.y +
                       vec3(-0.07367f, -0.00605f, 1.07602f) * curve.z;
  return clamp(shown, 0.0f, 1.0f);
}

// Linear -> sRGB (IEC 61966-2-1). x^(1/2.4) from square roots, within 0.001 (a quarter of a byte's
// step) and from 0.021 on within 0.0003.
FUNCTION float encodedOne(float x) {
  float a = root(x), b = root(a), c = root(b);
  ROUNDED float high = 0.662002687f * a + 0.684122060f * b - 0.323583601f * c - 0.0225411470f * x;
  ROUNDED float low = 12.92f * x;
  return x < 0.0031308f ? low : high;
}
FUNCTION vec3 encoded(vec3 x) {
  return vec3(encodedOne(x.x), encodedOne(x.y), encodedOne(x.z));
}

// Ordered 4x4 pattern of half a step either way: gradients do not band, files stay small. As a fraction of full white.
FUNCTION float dither(ivec2 at) {
  int x = at.x & 3, y = at.y & 3, z = x ^ y;
  int rank = ((z & 1) << 3) | ((y & 1) << 2) | (z & 2) | (y >> 1);
  ROUNDED float step_ = (float(rank) - 7.5f) * 0.000245098039f;  // 1 / (16 * 255)
  return step_;
}
