// Compressed brightness, with which the samples of a pixel that shows several primitives are averaged. A plain mean of
// linear light is dominated by the brightest sample, so that the edges of highlights look jagged. Compiles as GLSL and
// as C++. Brightness is the mean of the three channels, times the exposure: 1 is about white.
FUNCTION float brightnessOf(vec3 light, float exposure) {
  precise float brightness = (light.r + light.g + light.b) * exposure * 0.333333343f;
  return min(brightness, 1e6f);
}

// Compresses brightness above 1/2 to below 1, with a continuous slope: 1 - 1 / (4 b).
FUNCTION float compressedBrightness(float b) {
  precise float compressed = 1.0f - 0.25f * exactReciprocal(max(b, 0.5f));
  return b <= 0.5f ? b : compressed;
}

// Returns the inverse of compressedBrightness().
FUNCTION float expandedBrightness(float compressed) {
  precise float below = 1.0f - compressed;
  precise float expanded = 0.25f * exactReciprocal(clamp(below, 2.5e-7f, 0.5f));
  return compressed <= 0.5f ? compressed : expanded;
}

// Returns the factor on the light of a pixel whose samples have the mean compressed brightness `compressed` times the
// coverage. `light` is the linear mean, with the coverage as alpha. The factor is 1 if the samples have similar
// brightness.
FUNCTION float edgeFactor(vec4 light, float compressed, float exposure) {
  float perCoverage = exactReciprocal(max(light.a, 1e-6f));
  precise float linear = brightnessOf(vec3(light), exposure) * perCoverage;
  precise float mean = compressed * perCoverage;
  float evened = expandedBrightness(mean);
  precise float most = 0.999f * linear;
  precise float factor = evened * exactReciprocal(max(linear, 1e-6f));
  return compressed <= 0.0f || evened >= most ? 1.0f : factor;
}
