// Converts light to the encoded values of a picture. TONE: tone curve, a value of scene::Tone; the default is 0 (ACES).
// Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"
#ifndef TONE
#define TONE 0
#endif

// Applies the ACES reference rendering and sRGB output transforms as fitted by Stephen Hill (BakingLab,
// ToneMapping.hlsl): a matrix, a curve, a second matrix. The code lists the columns of the matrices. With the factor
// 1.3, matt white under the default sun becomes slightly darker than white.
FUNCTION vec3 filmedAces(vec3 light) {
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

// AgX by Troy Sobotka, in Benjamin Wrensch's fit (iolite-engine.com, "Minimal AgX Implementation"). A matrix moves the
// primaries inwards so that bright colours become white. The curve is a polynomial over 16.5 stops. A second matrix
// moves the primaries back. The result, encoded for a display of gamma 2.2, is converted to light.
FUNCTION float agxCurve(float light) {
  ROUNDED float stops = (logarithmOfTwo(max(light, 1e-10f)) + 12.47393f) * 0.0606060661f;
  float x = clamp(stops, 0.0f, 1.0f);
  ROUNDED float curve = (((((15.5f * x - 40.14f) * x + 31.96f) * x - 6.868f) * x + 0.4298f) * x + 0.1191f) * x - 0.00232f;
  return curve;
}
FUNCTION float fromGamma(float x) {
  ROUNDED float doublings = 2.2f * logarithmOfTwo(max(x, 1e-6f));
  return powerOfTwo(doublings);
}
FUNCTION vec3 filmedAgx(vec3 light) {
  ROUNDED vec3 v = vec3(0.842479062f, 0.042328242f, 0.042375655f) * light.x +
                   vec3(0.078433600f, 0.878468636f, 0.078433600f) * light.y +
                   vec3(0.079223745f, 0.079166127f, 0.879142974f) * light.z;
  vec3 curve = vec3(agxCurve(v.x), agxCurve(v.y), agxCurve(v.z));
  ROUNDED vec3 shown = vec3(1.196879005f, -0.052896852f, -0.052971636f) * curve.x +
                       vec3(-0.098020881f, 1.151903130f, -0.098043450f) * curve.y +
                       vec3(-0.099029744f, -0.098961177f, 1.151073673f) * curve.z;
  return vec3(fromGamma(clamp(shown.x, 0.0f, 1.0f)), fromGamma(clamp(shown.y, 0.0f, 1.0f)),
              fromGamma(clamp(shown.z, 0.0f, 1.0f)));
}

// John Hable's curve for "Uncharted 2" (GDC 2010, "HDR Lighting") with a linear white of 11.2 after doubling: h(x) /
// h(11.2), with h(x) = (x (0.15 x + 0.05) + 0.004) / (x (0.15 x + 0.5) + 0.06) - 0.02 / 0.3.
FUNCTION vec3 filmedFilmic(vec3 light) {
  ROUNDED vec3 x = 2.0f * light;
  ROUNDED vec3 over = x * (0.15f * x + 0.05f) + 0.004f;
  ROUNDED vec3 under = x * (0.15f * x + 0.5f) + 0.06f;
  ROUNDED vec3 shown = (over * vec3(inverse(under.x), inverse(under.y), inverse(under.z)) - 0.0666666667f) * 1.37906429f;
  return clamp(shown, 0.0f, 1.0f);
}

FUNCTION vec3 filmed(vec3 light) {
#if TONE == 1
  return filmedAgx(light);
#elif TONE == 2
  return filmedFilmic(light);
#elif TONE == 3
  return clamp(light, 0.0f, 1.0f);
#else
  return filmedAces(light);
#endif
}

// Converts linear light to sRGB (IEC 61966-2-1). DEEP, for 16-bit output: the error is at most a quarter of a 16-bit
// step. Otherwise, x^(1/2.4) is approximated with square roots. The error is at most 0.001 (a quarter of a byte's
// step), and 0.0003 for x >= 0.021.
#ifdef DEEP
FUNCTION float encodedOne(float x) {
  ROUNDED float doublings = logarithmOfTwo(max(x, 1e-6f)) * 0.416666667f;
  ROUNDED float high = 1.055f * powerOfTwo(doublings) - 0.055f;
  ROUNDED float low = 12.92f * x;
  return x < 0.0031308f ? low : high;
}
#else
FUNCTION float encodedOne(float x) {
  float a = root(x), b = root(a), c = root(b);
  ROUNDED float high = 0.662002687f * a + 0.684122060f * b - 0.323583601f * c - 0.0225411470f * x;
  ROUNDED float low = 12.92f * x;
  return x < 0.0031308f ? low : high;
}
#endif
FUNCTION vec3 encoded(vec3 x) {
  return vec3(encodedOne(x.x), encodedOne(x.y), encodedOne(x.z));
}

// Returns an ordered 4x4 dither offset of up to half a byte's step, as a fraction of full white. The pattern avoids
// banding in gradients and keeps compressed files small.
FUNCTION float dither(ivec2 at) {
  int x = at.x & 3, y = at.y & 3, z = x ^ y;
  int rank = ((z & 1) << 3) | ((y & 1) << 2) | (z & 2) | (y >> 1);
  ROUNDED float step_ = (float(rank) - 7.5f) * 0.000245098039f;  // 1 / (16 * 255), a sixteenth of a byte's step
  return step_;
}
