// Visibility buffer of the rasterizing kernels. PASS 0 keeps the smallest depth key of each sample; pass 1 keeps the
// lowest primitive id among those with that key. ONE_PASS: pass 0 does both.
// SAMPLES: samples per pixel. PAIRED: the id and the key of a sample are stored together, id first (sample_read.glsl).
// SUN_MAP: only keys, for the sun's shadow map. LAMP_MAP: only keys, for one face of a lamp's shadow maps. FACES: with
// LAMP_MAP, one dispatch handles several faces (view_block.glsl), so the place of a face's first key comes from its
// view instead of a uniform. ADDS: the kernel adds light instead of storing visible samples, so the buffers and keep()
// are not declared.
#include "draw/exact/sample_read.glsl"
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
uniform int keyStride;  // number of keys from one row of the map to the next
#ifdef FACES
int firstKey = int(view.eye.w) * keyStride + int(view.across.w);
#else
uniform int firstKey;   // index of the first key of this map in the atlas of all lamps
#endif
#endif

int sampleIndex(ivec2 pixel, int s) {
#ifdef LAMP_MAP
  return firstKey + pixel.y * keyStride + pixel.x;
#elif defined SUN_MAP
  return pixel.y * mapTexels + pixel.x;
#else
  return firstSample(pixel) + s;
#endif
}
#ifndef ADDS
// Buffers of keys and ids. sample_read.glsl reads the same memory.
#ifdef ONE_PASS
layout(std430, binding = nearBinding) restrict buffer NearBlock { uint64_t pairs[]; };
#elif defined PAIRED
layout(std430, binding = nearBinding) restrict buffer NearBlock { uint words[]; };
#else
layout(std430, binding = nearBinding) restrict buffer NearBlock { uint nearKeys[]; };
layout(std430, binding = idBinding) restrict buffer IdBlock { uint ids[]; };
#endif

// Stores key and id at a sample if they are nearer than the stored ones. `before` is a key that was read from the
// sample earlier.
void keep(int at, uint key, uint before, uint id) {
#ifdef ONE_PASS
  if (key <= before) atomicMin(pairs[at], packUint2x32(uvec2(id, key)));
#elif defined PAIRED
#if PASS == 0
  if (key < before) atomicMin(words[2 * at + 1], key);
#else
  if (key == before) atomicMin(words[2 * at], id);
#endif
#elif PASS == 0
  if (key < before) atomicMin(nearKeys[at], key);
#else
  if (key == before) atomicMin(ids[at], id);
#endif
}
#endif
