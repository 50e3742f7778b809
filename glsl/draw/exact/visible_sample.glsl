// Where the kernels that find what is visible keep it. PASS 0 keeps the nearest at each sample, pass 1 the least number
// among those that are as near. SAMPLES. SUN_MAP: the nearest of each texel of the sun's map alone; LAMP_MAP: of one face of a lamp's maps, seen as
// a picture is. ADDS: neither.
#include "draw/exact/bindings.glsl"
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

int sampleIndex(ivec2 pixel, int s) {
#ifdef LAMP_MAP
  return firstKey + pixel.y * keyStride + pixel.x;
#elif defined SUN_MAP
  return pixel.y * mapTexels + pixel.x;
#else
  return firstSample(pixel) + s;
#endif
}
layout(binding = nearUnit) uniform usamplerBuffer nearestKeys;    // the memory of nearKeys
layout(binding = nearFoursUnit) uniform usamplerBuffer nearestFours;  // the same, four a texel
#ifndef ADDS
layout(std430, binding = nearBinding) restrict buffer NearBlock { uint nearKeys[]; };
layout(std430, binding = idBinding) restrict buffer IdBlock { uint ids[]; };

// At a sample where the nearest was `before`.
void keep(int at, uint key, uint before, uint id) {
#if PASS == 0
  if (key < before) atomicMin(nearKeys[at], key);
#else
  if (key == before) atomicMin(ids[at], id);
#endif
}
#endif
