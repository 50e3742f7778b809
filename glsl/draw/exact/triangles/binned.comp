// What of the triangles that bins.glsl lists is nearest in a tile, and where they are as near the least number: beside what
// is known there already. A group does a tile, an invocation a part of a column of it: samples stay in registers, eight fours
// of them where there are as many. Such as these are: of four samples row by row, of fewer of several rows. SAMPLES, SUN_MAP, LAMP_MAP.
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
uniform int firstKey;   // of this map among those of all lamps
uniform int keyStride;  // from one row to the next
#endif
#if defined SUN_MAP || defined LAMP_MAP
#define KEYS_ONLY
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

// All fours of an invocation: FOUR(j) for each.
#if SAMPLES == 1
#define ALL_FOURS FOUR(0) FOUR(1)
#elif SAMPLES == 2
#define ALL_FOURS FOUR(0) FOUR(1) FOUR(2) FOUR(3)
#else
#define ALL_FOURS FOUR(0) FOUR(1) FOUR(2) FOUR(3) FOUR(4) FOUR(5) FOUR(6) FOUR(7)
#endif
// Sample i of four j is sample SAMPLE_OF(j, i) of the pixel in row ROW_OF(j, i).
#define ROW_OF(J, I) ((4 * (J) + (I)) / SAMPLES)
#define SAMPLE_OF(J, I) ((4 * (J) + (I)) % SAMPLES)
#define PART_OF(J) ((J) % foursOfPixel)
const int rowsOfFour = SAMPLES < 4 ? 4 / SAMPLES : 1;  // that the next one is below

// Of the four of part f, from the first pixel's corner (1/256 pixel).
ivec4 acrossTo(int f) {
  return ivec4(samplePlace(SAMPLE_OF(f, 0)).x, samplePlace(SAMPLE_OF(f, 1)).x, samplePlace(SAMPLE_OF(f, 2)).x,
               samplePlace(SAMPLE_OF(f, 3)).x) * (subpixels / 16);
}
ivec4 downTo(int f) {
  return ivec4(samplePlace(SAMPLE_OF(f, 0)).y, samplePlace(SAMPLE_OF(f, 1)).y, samplePlace(SAMPLE_OF(f, 2)).y,
               samplePlace(SAMPLE_OF(f, 3)).y) * (subpixels / 16) +
         (SAMPLES < 4 ? ivec4(0, ROW_OF(0, 1), ROW_OF(0, 2), ROW_OF(0, 3)) : ivec4(0)) * subpixels;
}

// E / 16 as in edgeOverSixteen, which serves all of a column: of edges of at most 8192 pixels it changes by less than what that
// holds it beyond.
ivec4 edgeOfFour(Edge edge, int sixteenth, int f) {
  return sixteenth + edge.step_.y * (acrossTo(f) / 16) - edge.step_.x * (downTo(f) / 16);
}

int placeOf(ivec2 pixel, int s) {
#ifdef LAMP_MAP
  return firstKey + pixel.y * keyStride + pixel.x;
#elif defined SUN_MAP
  return pixel.y * mapTexels + pixel.x;
#else
  return firstSample(pixel) + s;
#endif
}

#if SAMPLES < 4
#define LOADED(ALONE, FOUR_, PIXEL, J)                                                                             \
  uvec4(ALONE(placeOf(PIXEL + ivec2(0, ROW_OF(J, 0)), SAMPLE_OF(J, 0))),                                           \
        ALONE(placeOf(PIXEL + ivec2(0, ROW_OF(J, 1)), SAMPLE_OF(J, 1))),                                           \
        ALONE(placeOf(PIXEL + ivec2(0, ROW_OF(J, 2)), SAMPLE_OF(J, 2))),                                           \
        ALONE(placeOf(PIXEL + ivec2(0, ROW_OF(J, 3)), SAMPLE_OF(J, 3))))
#else
#define LOADED(ALONE, FOUR_, PIXEL, J) FOUR_(placeOf(PIXEL + ivec2(0, ROW_OF(J, 0)), SAMPLE_OF(J, 0)))
#endif

// As kept, what is empty as `none`.
vec4 nearOf(uvec4 keys, float none) {
  vec4 near = uintBitsToFloat(0x7fffffffu - keys);
  return vec4(keys.x == ~0u ? none : near.x, keys.y == ~0u ? none : near.y, keys.z == ~0u ? none : near.z,
              keys.w == ~0u ? none : near.w);
}

const int noId = 0x7fffffff;  // beyond all that triangles have

// What was there `before` where nothing came.
uvec4 keysOf(vec4 near) {
  uvec4 keys = 0x7fffffffu - floatBitsToUint(near);
  return uvec4(near.x < 0.0f ? ~0u : keys.x, near.y < 0.0f ? ~0u : keys.y, near.z < 0.0f ? ~0u : keys.z,
               near.w < 0.0f ? ~0u : keys.w);
}

uvec4 keysOf(vec4 near, ivec4 id, uvec4 before) {
  uvec4 keys = 0x7fffffffu - floatBitsToUint(near);
  return uvec4(id.x == noId ? before.x : keys.x, id.y == noId ? before.y : keys.y, id.z == noId ? before.z : keys.z,
               id.w == noId ? before.w : keys.w);
}

uvec4 numbersOf(ivec4 id) {
  return uvec4(id.x == noId ? ~0u : uint(id.x), id.y == noId ? ~0u : uint(id.y), id.z == noId ? ~0u : uint(id.z),
               id.w == noId ? ~0u : uint(id.w));
}

void main() {
  uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (entry >= texelFetch(bins, firstTileCount + round_).x) return;
  int list = int(texelFetch(bins, binCounts + (rounds + round_) * binTiles + int(entry)).x);
  int columns = (PICTURE_SIZE.x + tileSide - 1) / tileSide, tile = list - round_ * binTiles;
  ivec2 size = ivec2(PICTURE_SIZE.x, PICTURE_ROWS.y);
  const int rows = tileSide / foursOfPixel;
  ivec2 pixel = ivec2(tile % columns, tile / columns) * tileSide + ivec2(0, PICTURE_ROWS.x) +
                ivec2(gl_LocalInvocationID.xy) * ivec2(1, rows);
  ivec2 corner = pixel * subpixels;
#ifndef KEYS_ONLY
  float least = view.nearOverFar;
#endif
// Nearness and numbers are kept as what compares them fastest: floats, where empty as near as may just be seen, or less.
#ifdef KEYS_ONLY
#define FOUR(J) vec4 nearest##J = nearOf(LOADED(keyAt, fourKeysAt, pixel, J), -1.0f);
#else
#define FOUR(J)                                                                \
  vec4 nearest##J = nearOf(LOADED(keyAt, fourKeysAt, pixel, J), least);        \
  ivec4 ids##J = ivec4(min(LOADED(idAt, fourIdsAt, pixel, J), uvec4(noId)));
#endif
  ALL_FOURS
#undef FOUR
  uint node = texelFetch(bins, binCounts + list).x;
  while (node != 0u) {
    uvec2 here = texelFetch(nodes, int(node) - 1).xy;
    node = here.x;
    int at = int(here.y) * binTexels;
    uvec4 first = texelFetch(binned, at), second = texelFetch(binned, at + 1);
    vec4 plane = uintBitsToFloat(texelFetch(binned, at + 2));
    ivec2 a = ivec2(first.xy), b = ivec2(first.zw), c = ivec2(second.xy);
    int id = int(second.z);
    float near = uintBitsToFloat(second.w);
    Edge ab = edgeOf(a, b), bc = edgeOf(b, c), ca = edgeOf(c, a);
    int cornerAb = edgeOverSixteen(ab, corner), cornerBc = edgeOverSixteen(bc, corner), cornerCa = edgeOverSixteen(ca, corner);
    ivec4 sidesAb[foursOfPixel], sidesBc[foursOfPixel], sidesCa[foursOfPixel], down[foursOfPixel];
    vec4 across[foursOfPixel];
    for (int f = 0; f < foursOfPixel; ++f) {
      sidesAb[f] = edgeOfFour(ab, cornerAb, f);
      sidesBc[f] = edgeOfFour(bc, cornerBc, f);
      sidesCa[f] = edgeOfFour(ca, cornerCa, f);
      precise vec4 terms = plane.x * vec4(corner.x + acrossTo(f) - a.x);
      across[f] = terms;
      down[f] = corner.y + downTo(f) - a.y;
    }
    const int below = rowsOfFour * subpixels, below16 = below / 16;
    int belowAb = ab.step_.x * below16, belowBc = bc.step_.x * below16, belowCa = ca.step_.x * below16;
#ifdef KEYS_ONLY
#define KEEP(J, I) nearest##J[I] = covered[I] && nears[I] > nearest##J[I] ? nears[I] : nearest##J[I];
#else
#define KEEP(J, I)                                                                                                   \
  {                                                                                                                  \
    bool wins = covered[I] && (nears[I] > nearest##J[I] || (nears[I] == nearest##J[I] && id < ids##J[I]));           \
    nearest##J[I] = wins ? nears[I] : nearest##J[I];                                                                 \
    ids##J[I] = wins ? id : ids##J[I];                                                                               \
  }
#endif
#define FOUR(J)                                                                                                      \
  {                                                                                                                  \
    const int f = PART_OF(J);                                                                                        \
    bvec4 covered = greaterThanEqual(sidesAb[f] | sidesBc[f] | sidesCa[f], ivec4(0));                                \
    precise vec4 nears = near + (across[f] + plane.y * vec4(down[f]));                                               \
    for (int i = 0; i < 4; ++i) nears[i] = nears[i] > plane.z ? nears[i] : plane.z;                                  \
    for (int i = 0; i < 4; ++i) nears[i] = nears[i] < plane.w ? nears[i] : plane.w;                                  \
    KEEP(J, 0) KEEP(J, 1) KEEP(J, 2) KEEP(J, 3)                                                                                                          \
    sidesAb[f] -= belowAb;                                                                                           \
    sidesBc[f] -= belowBc;                                                                                           \
    sidesCa[f] -= belowCa;                                                                                           \
    down[f] += below;                                                                                                \
  }
    ALL_FOURS
#undef FOUR
  }
  if (pixel.x >= size.x) return;
#ifdef KEYS_ONLY
#define PUT(J, I) if (pixel.y + ROW_OF(J, I) < size.y) nearKeys[placeOf(pixel + ivec2(0, ROW_OF(J, I)), 0)] = keys[I];
#define FOUR(J)                                                                       \
  {                                                                                   \
    uvec4 keys = keysOf(nearest##J);                                                     \
    PUT(J, 0) PUT(J, 1) PUT(J, 2) PUT(J, 3)                                           \
  }
#elif SAMPLES < 4
#define PUT(J, I)                                                                     \
  if (pixel.y + ROW_OF(J, I) < size.y) {                                              \
    int at = placeOf(pixel + ivec2(0, ROW_OF(J, I)), SAMPLE_OF(J, I));                \
    nearKeys[at] = keys[I];                                                           \
    ids[at] = numbers[I];                                                             \
  }
#define FOUR(J)                                                                       \
  {                                                                                   \
    uvec4 keys = keysOf(nearest##J, ids##J, LOADED(keyAt, fourKeysAt, pixel, J));     \
    uvec4 numbers = numbersOf(ids##J);                                                \
    PUT(J, 0) PUT(J, 1) PUT(J, 2) PUT(J, 3)                                           \
  }
#else
#define FOUR(J)                                                                       \
  if (pixel.y + ROW_OF(J, 0) < size.y) {                                              \
    int at = placeOf(pixel + ivec2(0, ROW_OF(J, 0)), SAMPLE_OF(J, 0)) / 4;            \
    nearKeys[at] = keysOf(nearest##J, ids##J, LOADED(keyAt, fourKeysAt, pixel, J));   \
    ids[at] = numbersOf(ids##J);                                                      \
  }
#endif
  ALL_FOURS
}
