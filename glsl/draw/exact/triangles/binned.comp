// Rasterizes the triangles in the tile lists of bins.glsl. At each sample it finds the nearest triangle, or the lowest
// id among equally near ones, and compares it with the existing content of the visibility buffer. One workgroup handles
// one tile. One invocation handles part of a column, whose samples stay in registers in groups of four. A group holds
// samples of one pixel or, with fewer than four samples per pixel, of several rows. SUN_MAP or LAMP_MAP: keys only.
// Define: SAMPLES.
#include "draw/exact/sample_read.glsl"
#include "draw/exact/triangles/triangle.glsl"
#include "draw/exact/triangles/bins.glsl"
#ifdef SUN_MAP
uniform int mapTexels;
ivec2 mapSize = ivec2(mapTexels);
#define PICTURE_SIZE mapSize
#define PICTURE_ROWS ivec2(0, mapTexels)
#else
#include "draw/exact/view_block.glsl"
#define PICTURE_SIZE view.size
#define PICTURE_ROWS view.rows
#endif
#ifdef LAMP_MAP
uniform int firstKey;   // index of the first key of this map in the atlas of all lamps
uniform int keyStride;  // number of keys from one row of the map to the next
#endif
#if defined SUN_MAP || defined LAMP_MAP
#define KEYS_ONLY
#endif
// Applies a macro to each group of four samples of an invocation.
#if SAMPLES == 1
#define ALL_FOURS(EACH) EACH(0) EACH(1)
#elif SAMPLES == 2
#define ALL_FOURS(EACH) EACH(0) EACH(1) EACH(2) EACH(3)
#else
#define ALL_FOURS(EACH) EACH(0) EACH(1) EACH(2) EACH(3) EACH(4) EACH(5) EACH(6) EACH(7)
#endif
#if SAMPLES > 4
const int foursOfPixel = SAMPLES / 4;
#else
const int foursOfPixel = 1;
#endif
layout(local_size_x = 8, local_size_y = foursOfPixel) in;
layout(binding = vertexUnit) uniform usamplerBuffer binned;
layout(binding = indexUnit) uniform usamplerBuffer nodes;
layout(binding = tileListUnit) uniform usamplerBuffer bins;
#if SAMPLES < 4
layout(std430, binding = nearBinding) writeonly restrict buffer NearBlock { uint nearKeys[]; };
layout(std430, binding = idBinding) writeonly restrict buffer IdBlock { uint ids[]; };
#else
layout(std430, binding = nearBinding) writeonly restrict buffer NearBlock { uvec4 nearKeys[]; };
layout(std430, binding = idBinding) writeonly restrict buffer IdBlock { uvec4 ids[]; };
#endif
uniform int binTiles;
uniform int rounds;
uniform int round_;
const int noId = 0x7fffffff;  // placeholder id, greater than all triangle ids

// These functions return the row of the pixel, and the sample index, of sample i in group j.
int rowOf(int j, int i) {
  return (4 * j + i) / SAMPLES;
}
int sampleOf(int j, int i) {
  return (4 * j + i) % SAMPLES;
}

// Returns the position of sample i in the first group with the same pattern, in 1/16 pixel from the corner of the first
// pixel.
ivec2 placeOf(int f, int i) {
  return samplePlace(sampleOf(f, i)) + ivec2(0, SAMPLES < 4 ? 16 * rowOf(0, i) : 0);
}

int indexOf(ivec2 pixel, int j, int i) {
  ivec2 at = pixel + ivec2(0, rowOf(j, i));
#ifdef LAMP_MAP
  return firstKey + at.y * keyStride + at.x;
#elif defined SUN_MAP
  return at.y * mapTexels + at.x;
#else
  return firstSample(at) + sampleOf(j, i);
#endif
}

uvec4 keysAt(ivec2 pixel, int j) {
#if SAMPLES < 4
  return uvec4(keyAt(indexOf(pixel, j, 0)), keyAt(indexOf(pixel, j, 1)), keyAt(indexOf(pixel, j, 2)),
               keyAt(indexOf(pixel, j, 3)));
#else
  return fourKeysAt(indexOf(pixel, j, 0));
#endif
}

// Returns the ids of a group. Empty samples get noId, so that ids can be compared as signed integers.
ivec4 idsAt(ivec2 pixel, int j) {
#if SAMPLES < 4
  uvec4 found = uvec4(idAt(indexOf(pixel, j, 0)), idAt(indexOf(pixel, j, 1)), idAt(indexOf(pixel, j, 2)),
                      idAt(indexOf(pixel, j, 3)));
#else
  uvec4 found = fourIdsAt(indexOf(pixel, j, 0));
#endif
  return ivec4(min(found, uvec4(noId)));
}

// Converts keys to floats, whose comparison is fastest. `none` is the value for empty samples.
vec4 nearOf(uvec4 keys, float none) {
  vec4 near = uintBitsToFloat(0x7fffffffu - keys);
  return vec4(keys.x == ~0u ? none : near.x, keys.y == ~0u ? none : near.y, keys.z == ~0u ? none : near.z,
              keys.w == ~0u ? none : near.w);
}

uint keyOf(float near) {
  return near < 0.0f ? ~0u : 0x7fffffffu - uint(floatBitsToInt(near));
}

// A group of four samples relative to a triangle: edge function E / 16 of each edge, distance below the triangle's
// first corner, and change of nearness to the right of that corner.
struct Four {
  ivec4 ab, bc, ca, down;
  vec4 across;
};

ivec4 edgeOfFour(Edge edge, int sixteenth, int f) {
  return ivec4(edgeAside(edge, sixteenth, placeOf(f, 0)), edgeAside(edge, sixteenth, placeOf(f, 1)),
               edgeAside(edge, sixteenth, placeOf(f, 2)), edgeAside(edge, sixteenth, placeOf(f, 3)));
}

vec4 nearAt(Four four, float first, vec4 plane) {
  precise vec4 near = first + (four.across + plane.y * vec4(four.down));
  for (int i = 0; i < 4; ++i) {
    float minimum = near[i] > plane.z ? near[i] : plane.z;
    near[i] = minimum < plane.w ? minimum : plane.w;
  }
  return near;
}

bool covers(Four four, int i) {
  return (four.ab[i] | four.bc[i] | four.ca[i]) >= 0;
}

void main() {
  uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (entry >= texelFetch(bins, firstTileCount + round_).x) return;
  int list = int(texelFetch(bins, binCounts + (rounds + round_) * binTiles + int(entry)).x);
  int columns = (PICTURE_SIZE.x + tileSide - 1) / tileSide, tile = list - round_ * binTiles;
  ivec2 size = ivec2(PICTURE_SIZE.x, PICTURE_ROWS.y);
  ivec2 pixel = ivec2(tile % columns, tile / columns) * tileSide + ivec2(0, PICTURE_ROWS.x) +
                ivec2(gl_LocalInvocationID.xy) * ivec2(1, tileSide / foursOfPixel);
  ivec2 corner = pixel * subpixels;
#ifdef KEYS_ONLY
#define LOAD(J) vec4 near##J = nearOf(keysAt(pixel, J), -1.0f);
#else
  float minimum = view.nearOverFar;
#define LOAD(J) vec4 near##J = nearOf(keysAt(pixel, J), minimum); ivec4 id##J = idsAt(pixel, J);
#endif
  ALL_FOURS(LOAD);
  uint node = texelFetch(bins, binCounts + list).x;
  while (node != 0u) {
    uvec2 here = texelFetch(nodes, int(node) - 1).xy;
    node = here.x;
    int at = int(here.y) * binTexels;
    uvec4 first = texelFetch(binned, at), second = texelFetch(binned, at + 1);
    vec4 plane = uintBitsToFloat(texelFetch(binned, at + 2));
    ivec2 a = ivec2(first.xy), b = ivec2(first.zw), c = ivec2(second.xy);
    int id = int(second.z);
    float nearest = uintBitsToFloat(second.w);
    Edge ab = edgeOf(a, b), bc = edgeOf(b, c), ca = edgeOf(c, a);
    // The limits of edgeOverSixteen() hold for the whole column, because edges are at most 8192 pixels long.
    int cornerAb = edgeOverSixteen(ab, corner), cornerBc = edgeOverSixteen(bc, corner), cornerCa = edgeOverSixteen(ca, corner);
    Four fours[foursOfPixel];
    for (int f = 0; f < foursOfPixel; ++f) {
      fours[f].ab = edgeOfFour(ab, cornerAb, f);
      fours[f].bc = edgeOfFour(bc, cornerBc, f);
      fours[f].ca = edgeOfFour(ca, cornerCa, f);
      ivec4 x = ivec4(placeOf(f, 0).x, placeOf(f, 1).x, placeOf(f, 2).x, placeOf(f, 3).x) * (subpixels / 16);
      ivec4 y = ivec4(placeOf(f, 0).y, placeOf(f, 1).y, placeOf(f, 2).y, placeOf(f, 3).y) * (subpixels / 16);
      precise vec4 across = plane.x * vec4(corner.x + x - a.x);
      fours[f].across = across;
      fours[f].down = corner.y + y - a.y;
    }
    const int below = SAMPLES < 4 ? 4 / SAMPLES : 1;  // number of rows from one group of four samples to the next
    int belowAb = ab.step_.x * (16 * below), belowBc = bc.step_.x * (16 * below), belowCa = ca.step_.x * (16 * below);
#define BELOW(J)                                 \
    fours[J % foursOfPixel].ab -= belowAb;       \
    fours[J % foursOfPixel].bc -= belowBc;       \
    fours[J % foursOfPixel].ca -= belowCa;       \
    fours[J % foursOfPixel].down += below * subpixels;
#ifdef KEYS_ONLY
#define KEEP(J)                                                            \
    {                                                                      \
      Four four = fours[J % foursOfPixel];                                 \
      vec4 found = nearAt(four, nearest, plane);                           \
      for (int i = 0; i < 4; ++i) {                                        \
        bool wins = covers(four, i) && found[i] > near##J[i];              \
        near##J[i] = wins ? found[i] : near##J[i];                         \
      }                                                                    \
      BELOW(J)                                                             \
    }
#else
#define KEEP(J)                                                                                          \
    {                                                                                                    \
      Four four = fours[J % foursOfPixel];                                                               \
      vec4 found = nearAt(four, nearest, plane);                                                         \
      for (int i = 0; i < 4; ++i) {                                                                      \
        bool nearer = found[i] > near##J[i] || (found[i] == near##J[i] && id < id##J[i]);                \
        bool wins = nearer && covers(four, i);                                                           \
        near##J[i] = wins ? found[i] : near##J[i];                                                       \
        id##J[i] = wins ? id : id##J[i];                                                                 \
      }                                                                                                  \
      BELOW(J)                                                                                           \
    }
#endif
    ALL_FOURS(KEEP);
  }
  if (pixel.x >= size.x) return;
#ifdef KEYS_ONLY
#define PUT(J)                                                                                        \
  for (int i = 0; i < 4; ++i)                                                                         \
    if (pixel.y + rowOf(J, i) < size.y) nearKeys[indexOf(pixel, J, i)] = keyOf(near##J[i]);
#elif SAMPLES < 4
#define PUT(J)                                                                                        \
  for (int i = 0; i < 4; ++i)                                                                         \
    if (pixel.y + rowOf(J, i) < size.y) {                                                             \
      nearKeys[indexOf(pixel, J, i)] = id##J[i] == noId ? keysAt(pixel, J)[i] : keyOf(near##J[i]);     \
      ids[indexOf(pixel, J, i)] = id##J[i] == noId ? ~0u : uint(id##J[i]);                             \
    }
#else
#define PUT(J)                                                                                        \
  if (pixel.y + rowOf(J, 0) < size.y) {                                                               \
    uvec4 keys = keysAt(pixel, J), numbers = uvec4(id##J);                                            \
    for (int i = 0; i < 4; ++i) {                                                                     \
      keys[i] = id##J[i] == noId ? keys[i] : keyOf(near##J[i]);                                       \
      numbers[i] = id##J[i] == noId ? ~0u : numbers[i];                                               \
    }                                                                                                 \
    nearKeys[indexOf(pixel, J, 0) / 4] = keys;                                                        \
    ids[indexOf(pixel, J, 0) / 4] = numbers;                                                          \
  }
#endif
  ALL_FOURS(PUT);
}
