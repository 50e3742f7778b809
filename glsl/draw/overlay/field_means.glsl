// Averages blocks of a field's cells. Compiles as GLSL and as C++, after field_values.glsl.

// Returns sum / count. A correction step makes the result exact if a float can hold the quotient.
FUNCTION vec4 meanOf(vec4 sum, float count) {
  float each = inverse(count);
  ROUNDED vec4 rough = sum * each;
  ROUNDED vec4 mean = rough + (sum - rough * count) * each;
  return mean;
}

// Returns the fraction of set bits in the cells from `first` to `end` - 1.
FUNCTION float meanBit(ivec2 first, ivec2 end) {
  int count = 0;
  for (int y = first.y; y < end.y; ++y) {
    int row = firstWord + y * rowWords;
    for (int w = first.x >> 5; w <= (end.x - 1) >> 5; ++w) {
      int from = max(first.x - 32 * w, 0), till = min(end.x - 32 * w, 32);
      count += bitCount(bitfieldExtract(wordAt(row + w), from, till - from));
    }
  }
  return meanOf(vec4(float(count)), float((end.x - first.x) * (end.y - first.y))).x;
}

// Rounds x to the nearest half float (zero below 2^-14), so that a store in a half-float texel does not round again.
FUNCTION float asHalf(float x) {
  float held = clamp(x, -65504.0f, 65504.0f);
  int bits = floatBitsToInt(held);
  bits = (bits + 0xfff + ((bits >> 13) & 1)) & ~0x1fff;
  return abs(held) < 6.1035156e-5f ? 0.0f : intBitsToFloat(bits);
}

// Returns the mean of the cells from `first` to `end` - 1. With `colored`, rgb is the light and a is the position of
// the value in the range (0 to 1); otherwise, all components are the value.
FUNCTION vec4 blockMean(ivec2 first, ivec2 end) {
  if (cellKind == 0) {
    float share = meanBit(first, end);
    if (!colored) return vec4(share);
    vec3 color = blend(colorOf(0.0f), colorOf(1.0f), share);
    return vec4(asHalf(color.x), asHalf(color.y), asHalf(color.z), asHalf(placeOf(share)));
  }
  ROUNDED vec4 sum = vec4(0.0f);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      float value = valueOf(ivec2(x, y));
      sum = sum + (colored ? vec4(colorOfCell(ivec2(x, y), value), value) : vec4(value));
    }
  vec4 mean = meanOf(sum, float((end.x - first.x) * (end.y - first.y)));
  if (!colored) return mean;
  return vec4(asHalf(mean.x), asHalf(mean.y), asHalf(mean.z), asHalf(placeOf(mean.w)));
}

// Returns the mean of the cells that texel `at` of a texture covers. Texel i of `texels` starts at cell floor(i cells /
// texels). Block sizes therefore differ by at most one cell, and the texture ends exactly at the field's edge, so a
// tiled texture has no seam.
FUNCTION vec4 texelMean(ivec2 at, ivec2 texels) {
  return blockMean(ivec2(uvec2(at) * uvec2(cells) / uvec2(texels)),
                   ivec2(uvec2(at + 1) * uvec2(cells) / uvec2(texels)));
}
