// Filtered texture sampling for users' kernels, with the same bits on every driver: full-precision weights, nearest mip
// level. Sampler state: bit 0 is set for a linear filter; bits 2-3, 4-5 and 6-7 are the wrap modes in x, y and z (0
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
  precise float place = TIMES(at, float(n));
  precise float middle = place - 0.5;
  float from = floor((state & 1u) != 0u ? middle : place);
  precise float share = middle - from;
  texel = xToInt(from);
  return (state & 1u) != 0u ? share : 0.0;
}
vec4 xBetween(const vec4 a, const vec4 b, const float t) {
  precise vec4 d = b - a;
  precise vec4 sum = PLUS(a, TIMES(d, vec4(t)));
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

// Cube maps are array textures of the faces +x, -x, +y, -y, +z, -z, with the positions and directions of OpenGL and
// Direct3D. Returns the position on a face, from 0 to 1, and the index of the face.
vec3 xFace(const vec3 d) {
  vec3 size = abs(d);
  bool alongX = size.x >= size.y && size.x >= size.z, alongY = !alongX && size.y >= size.z;
  vec4 face = alongX   ? d.x < 0.0 ? vec4(d.z, -d.y, size.x, 1.0) : vec4(-d.z, -d.y, size.x, 0.0)
              : alongY ? d.y < 0.0 ? vec4(d.x, -d.z, size.y, 3.0) : vec4(d.x, d.z, size.y, 2.0)
              : d.z < 0.0 ? vec4(-d.x, -d.y, size.z, 5.0) : vec4(d.x, -d.y, size.z, 4.0);
  precise float s = 0.5 * xDiv(face.x, face.z) + 0.5, t = 0.5 * xDiv(face.y, face.z) + 0.5;
  return vec3(s, t, face.w);
}
// Returns the direction that belongs to a position on a face of a cube map.
vec3 xDirection(const int face, const float s, const float t) {
  precise float x = 2.0 * s - 1.0, y = 2.0 * t - 1.0;
  return face == 0   ? vec3(1.0, -y, -x)
         : face == 1 ? vec3(-1.0, -y, x)
         : face == 2 ? vec3(x, 1.0, y)
         : face == 3 ? vec3(x, -1.0, -y)
         : face == 4 ? vec3(x, -y, 1.0)
                     : vec3(-x, -y, -1.0);
}
// Returns the texel at (x, y) of a face. Outside the face, returns the nearest texel of the neighbouring face.
ivec3 xCubeTexel(const int face, const int x, const int y, const int n) {
  if (min(x, y) >= 0 && max(x, y) < n) return ivec3(x, y, face);
  precise float s = xDiv(float(x) + 0.5, float(n)), t = xDiv(float(y) + 0.5, float(n));
  vec3 other = xFace(xDirection(face, s, t));
  return ivec3(clamp(xToInt(floor(TIMES(other.x, float(n)))), 0, n - 1),
               clamp(xToInt(floor(TIMES(other.y, float(n)))), 0, n - 1), int(other.z));
}
#define TEXEL_CUBE(T, U) texelFetch(t, xCubeTexel(face, x + T, y + U, n), level)
#define SAMPLE_CUBE(TEXTURE) \
  vec4 xCube(TEXTURE t, const vec3 at, const float lod, const uint state) { \
    int level = xLevel(lod, textureQueryLevels(t)), n = textureSize(t, level).x, x, y; \
    vec3 place = xFace(at); \
    int face = int(place.z); \
    float shareX = xPlace(place.x, n, state, x), shareY = xPlace(place.y, n, state, y); \
    if ((state & 1u) == 0u) return texelFetch(t, ivec3(clamp(x, 0, n - 1), clamp(y, 0, n - 1), face), level); \
    return xBetween(xBetween(TEXEL_CUBE(0, 0), TEXEL_CUBE(1, 0), shareX), xBetween(TEXEL_CUBE(0, 1), TEXEL_CUBE(1, 1), shareX), shareY); \
  }
SAMPLE_CUBE(texture2DArray) SAMPLE_CUBE(sampler2DArray)
