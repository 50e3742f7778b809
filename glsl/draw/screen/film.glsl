// Fit of the ACES reference rendering and sRGB output transforms by Stephen Hill (BakingLab, ToneMapping.hlsl).
// The factor makes matt white under the default sun come out just short of white.
vec3 filmed(vec3 light) {
  const mat3 into = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 outOf = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = into * (1.3 * light);
  v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  return clamp(outOf * v, 0.0, 1.0);
}

// Linear -> sRGB (IEC 61966-2-1). x^(1/2.4) from square roots, within 0.0003 above the linear part.
vec3 encoded(vec3 x) {
  vec3 a = sqrt(x), b = sqrt(a), c = sqrt(b);
  vec3 high = 0.662002687 * a + 0.684122060 * b - 0.323583601 * c - 0.0225411470 * x;
  return mix(high, 12.92 * x, lessThan(x, vec3(0.0031308)));
}

// Ordered 4x4 pattern of half a step either way: gradients do not band, files stay small.
vec3 dither(ivec2 at) {
  int x = at.x & 3, y = at.y & 3, z = x ^ y;
  int rank = ((z & 1) << 3) | ((y & 1) << 2) | (z & 2) | (y >> 1);
  return vec3((float(rank) - 7.5) / (16.0 * 255.0));
}
