// Averages of the samples of a pixel that shows several primitives, with compressed brightness. A plain mean of linear
// light is dominated by the brightest sample, so that the edges of highlights look jagged. Compressed light has a
// negative coverage as its mark. Compiles as GLSL and as C++. Brightness is the mean of the three channels, times the
// exposure: 1 is about white.
FUNCTION float brightnessOf(vec3 light, float exposure) {
  precise float brightness = (light.r + light.g + light.b) * exposure * 0.333333343f;
  return min(brightness, 6e4f);
}

// Returns the factor that compresses light of brightness b above 1/2 to 1 - 1 / (4 b), with a continuous slope.
FUNCTION float compression(float b) {
  precise float inverse = exactReciprocal(max(b, 0.5f));
  precise float factor = (1.0f - 0.25f * inverse) * inverse;
  return b > 0.5f ? factor : 1.0f;
}

// Returns the factor that compresses the light of rays, of brightness b, in a pixel whose emission has the mean
// brightness `before`. Both parts together are compressed like one light, so that they never exceed 1, the limit of
// compressed brightness. Without emission the factor is compression(b).
FUNCTION float furtherCompression(float before, float b) {
  precise float all_ = before + b;
  precise float more = all_ * compression(all_) - before * compression(before);
  precise float factor = max(more, 0.0f) * exactReciprocal(max(b, 1e-6f));
  return before > 0.0f ? factor : compression(b);
}

// Returns the weights with which the light and the coverage of a primitive are added to a pixel whose light is `before`
// so far. `share` is the fraction of the pixel that shows the primitive, and b is the primitive's brightness. The light
// is compressed, unless the primitive fills the pixel (`whole`) or blended layers lie in front of it.
FUNCTION vec4 edgeWeights(vec4 before, float share, float b, bool whole) {
  precise float compressed = share * compression(b);
  return whole || before.a > 0.0f ? vec4(share) : vec4(compressed, compressed, compressed, -share);
}

// Returns the light of a pixel, in which compressed light is expanded again. Light of samples below a brightness of 1/2
// keeps its bits.
FUNCTION vec4 evenedLight(vec4 light, float exposure) {
  IF_ANY(light.a < 0.0f) {
    precise vec3 sum = vec3(light);
    precise float cover = -light.a;
    precise float b = brightnessOf(sum, exposure) * exactReciprocal(max(cover, 1e-6f));
    precise float slope = b * (1.0f - b);
    precise float factor = 0.25f * exactReciprocal(max(slope, 4e-6f));
    sum = b > 0.5f ? sum * factor : sum;
    light = vec4(sum, cover);
  }
  return light;
}
