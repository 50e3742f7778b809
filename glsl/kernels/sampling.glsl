// Filtered texture sampling of users' kernels, with the same bits on every driver: full-precision weights,
// nearest mip level. Sampler state: bit 0 linear filter; bits 2-3, 4-5 and 6-7 wrap mode in x, y and z (0
// repeat, 1 clamp, 2 mirror).
#include "kernels/numbers.glsl"

int xWrapped(const int i, const int n, const uint mode) {
  int r = xSmod(i, n), twice = xSmod(i, 2 * n);
  int mirrored = min(twice, 2 * n - 1 - twice);
  return mode == 0u ? r : mode == 2u ? mirrored : clamp(i, 0, n - 1);
}
int xLevel(const float lod, const int levels) {
  return clamp(xToInt(roundEven(xClamp(lod, 0.0, 32.0))), 0, max(levels - 1, 0));
}
// Returns the interpolation weight of the next texel for a normalized coordinate `at`, and the index of the
// lower texel in `texel`.
float xPlace(const float at, const int n, const uint state, out int texel) {
  precise float place = xMul(at, float(n));
  precise float middle = place - 0.5;
  float from = floor((state & 1u) != 0u ? middle : place);
  precise float share = middle - from;
  texel = xToInt(from);
  return (state & 1u) != 0u ? share : 0.0;
}
vec4 xBetween(const vec4 a, const vec4 b, const float t) {
  precise vec4 d = b - a;
  precise vec4 sum = a + xMul(d, vec4(t));
  return t == 0.0 ? a : sum;
}

#define TEXEL_2D(T, U) texelFetch(t, ivec2(xWrapped(x + T, n.x, (state >> 2) & 3u), xWrapped(y + U, n.y, (state >> 4) & 3u)), level)
#define SAMPLE_2D(TEXTURE) \
  vec4 xSample(TEXTURE t, const vec2 at, const float lod, const uint state) { \
    int level = xLevel(lod, textureQueryLevels(t)), x, y; \
    ivec2 n = textureSize(t, level); \
    float shareX = xPlace(at.x, n.x, state, x), shareY = xPlace(at.y, n.y, state, y); \
    if ((state & 1u) == 0u) return TEXEL_2D(0, 0); \
    return xBetween(xBetween(TEXEL_2D(0, 0), TEXEL_2D(1, 0), shareX), xBetween(TEXEL_2D(0, 1), TEXEL_2D(1, 1), shareX), shareY); \
  }
SAMPLE_2D(texture2D) SAMPLE_2D(sampler2D)

#define TEXEL_LAYER(T, U) \
  texelFetch(t, ivec3(xWrapped(x + T, n.x, (state >> 2) & 3u), xWrapped(y + U, n.y, (state >> 4) & 3u), layer), level)
#define SAMPLE_LAYER(TEXTURE) \
  vec4 xSample(TEXTURE t, const vec3 at, const float lod, const uint state) { \
    int level = xLevel(lod, textureQueryLevels(t)), x, y; \
    ivec3 n = textureSize(t, level); \
    int layer = clamp(xToInt(roundEven(at.z)), 0, n.z - 1); \
    float shareX = xPlace(at.x, n.x, state, x), shareY = xPlace(at.y, n.y, state, y); \
    if ((state & 1u) == 0u) return TEXEL_LAYER(0, 0); \
    return xBetween(xBetween(TEXEL_LAYER(0, 0), TEXEL_LAYER(1, 0), shareX), \
                    xBetween(TEXEL_LAYER(0, 1), TEXEL_LAYER(1, 1), shareX), shareY); \
  }
SAMPLE_LAYER(texture2DArray) SAMPLE_LAYER(sampler2DArray)

#define TEXEL_3D(T, U, V) \
  texelFetch(t, ivec3(xWrapped(x + T, n.x, (state >> 2) & 3u), xWrapped(y + U, n.y, (state >> 4) & 3u), \
                      xWrapped(z + V, n.z, (state >> 6) & 3u)), level)
#define SHEET_3D(V) \
  xBetween(xBetween(TEXEL_3D(0, 0, V), TEXEL_3D(1, 0, V), shareX), xBetween(TEXEL_3D(0, 1, V), TEXEL_3D(1, 1, V), shareX), shareY)
#define SAMPLE_3D(TEXTURE) \
  vec4 xSample(TEXTURE t, const vec3 at, const float lod, const uint state) { \
    int level = xLevel(lod, textureQueryLevels(t)), x, y, z; \
    ivec3 n = textureSize(t, level); \
    float shareX = xPlace(at.x, n.x, state, x), shareY = xPlace(at.y, n.y, state, y), shareZ = xPlace(at.z, n.z, state, z); \
    if ((state & 1u) == 0u) return TEXEL_3D(0, 0, 0); \
    return xBetween(SHEET_3D(0), SHEET_3D(1), shareZ); \
  }
SAMPLE_3D(texture3D) SAMPLE_3D(sampler3D)
