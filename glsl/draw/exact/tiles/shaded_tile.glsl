// Reads the tile of a workgroup from a list of tiles.comp, and the content of the invocation's pixels. One invocation
// handles ROWS pixels, 1 or 8. SAMPLES: samples per pixel. PAIRED: as in draw/exact/sample_read.glsl.
#include "draw/frame_block.glsl"
#include "draw/exact/view_block.glsl"
#include "draw/exact/tiles/tile_lists.glsl"
#include "draw/exact/sample_read.glsl"
#include "draw/exact/fixed.glsl"
layout(local_size_x = 8, local_size_y = 8 / ROWS) in;
layout(binding = tileListUnit) uniform usamplerBuffer tileLists;
layout(binding = counterUnit) uniform usamplerBuffer tileCounts;
layout(rgba32f, binding = sumImage) restrict uniform image2D sums;
uniform int draw_;
uniform int tileCount;

// Returns the first pixel of the workgroup's tile, or -1 if the list has no more tiles.
ivec2 tileToShade() {
  uint entry = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (entry >= texelFetch(tileCounts, draw_).x) return ivec2(-1);
  uint tile = texelFetch(tileLists, draw_ * tileCount + int(entry)).x;
  return ivec2(tile & 0xffffu, tile >> 16) * tileSide + ivec2(0, view.rows.x);
}

// Returns pixel i of the invocation in the tile whose first pixel is `corner`. On software drivers, the invocations of
// one vector form a 4x2 block, because fewer primitive edges cross a block than a row.
ivec2 pixelOf(ivec2 corner, int i) {
  int at = i * (64 / ROWS) + int(gl_LocalInvocationIndex);
  return corner + ivec2((at & 3) | (at >> 1 & 4), (at >> 2 & 1) | (at >> 3 & 6));
}

bool inPicture(ivec2 pixel) {
  return pixel.x < view.size.x && pixel.y < view.rows.y;
}

uint idAt(ivec2 pixel, int s) {
  return idAt(firstSample(pixel) + s);
}

struct PixelIds {
  uint of[SAMPLES];
};

// Returns the primitive ids of all samples of a pixel.
PixelIds idsOf(ivec2 pixel) {
  PixelIds ids;
  int first = firstSample(pixel);
#if SAMPLES < 4
  for (int s = 0; s < SAMPLES; ++s) ids.of[s] = idAt(first + s);
#else
  for (int s = 0; s < SAMPLES; s += 4) {
    uvec4 four = fourIdsAt(first + s);
    for (int i = 0; i < 4; ++i) ids.of[s + i] = four[i];
  }
#endif
  return ids;
}

// Returns the mask of the samples that show one of the ids first to first + numbers - 1.
int samplesOf(PixelIds shown, uint first, uint numbers) {
  int shows = 0;
  for (int s = 0; s < SAMPLES; ++s) shows |= shown.of[s] >= first && shown.of[s] - first < numbers ? 1 << s : 0;
  return shows;
}

// Returns the mask of the samples that show the same id as sample `first`.
int samplesLike(PixelIds shown, int first) {
  uint id = shown.of[0];
  for (int s = 1; s < SAMPLES; ++s) id = s == first ? shown.of[s] : id;
  int same = 0;
  for (int s = 0; s < SAMPLES; ++s) same |= shown.of[s] == id ? 1 << s : 0;
  return same;
}

// Returns the fraction of the pixel's light that comes from the samples in the mask. BEHIND: the blended layers in
// front reduce the fraction. BLENDED: they reduce it too, and the shaded layer reduces the fraction of everything
// behind it.
#ifdef BLENDED
layout(std430, binding = throughBinding) restrict buffer ThroughBlock { float through[]; };

float shareOf(ivec2 pixel, int samples, float alpha) {
  int first = firstSample(pixel);
  precise float sum = 0.0f;
  for (int s = 0; s < SAMPLES; ++s) {
    if ((samples >> s & 1) == 0) continue;
    float before = through[first + s];
    precise float part = before * alpha;
    precise float left = before - part;
    through[first + s] = left;
    sum = sum + part;
  }
  precise float share = sum * perSamples();
  return share;
}
#elif defined BEHIND
layout(binding = throughUnit) uniform samplerBuffer layersLeave;

float shareOf(ivec2 pixel, int samples, float alpha) {
  int first = firstSample(pixel);
  precise float sum = 0.0f;
  for (int s = 0; s < SAMPLES; ++s)
    if ((samples >> s & 1) != 0) sum = sum + texelFetch(layersLeave, first + s).x;
  precise float share = sum * perSamples();
  return share;
}
#else
float shareOf(ivec2 pixel, int samples, float alpha) {
  precise float share = float(bitCount(samples)) * perSamples();
  return share;
}
#endif

// RAYS: rays light the surface point (spot) later, so its fraction is stored.
#if defined RAYS && (defined BLENDED || defined BEHIND)
void keepShare(int sampleAt, float share);

void keepShareOf(ivec2 pixel, int samples, float share, float alpha) {
  precise float mean = share * alpha * float(SAMPLES) * exactReciprocal(float(bitCount(samples)));
  keepShare(firstSample(pixel) + findLSB(samples), mean);
}
#endif

// EVENED: compresses the light in pixels that show several primitives (screen/edge_light.glsl). FADES: the primitive's
// light is multiplied by its alpha.
#if SAMPLES > 1 && !defined REFLECTED && !defined SHOWN && !defined GLASS && !defined BLENDED
#define EVENED
#include "draw/exact/screen/edge_light.glsl"
uniform int linear;  // 1 to keep linear averages
int linear_ = once(linear);

vec4 evenedWeights(vec4 before, vec4 light, int samples, float share) {
  precise float b = brightnessOf(light.rgb, frame.exposure);
#ifdef FADES
  b = b * exactReciprocal(max(light.a, 1e-6f));
#endif
  return edgeWeights(before, share, linear_ == 1 ? 0.0f : b, bitCount(samples) == SAMPLES);
}
#endif

// Adds the light of the samples in the mask to a sum. Alpha accumulates the covered fraction of the pixel.
vec4 withLight(ivec2 pixel, vec4 before, vec4 light, int samples) {
  float share = shareOf(pixel, samples, light.a);
#ifdef BLENDED
  light.a = 1.0f;
#endif
#if defined RAYS && (defined BLENDED || defined BEHIND)
  keepShareOf(pixel, samples, share, light.a);
#endif
#ifdef EVENED
  precise vec4 sum = before + light * evenedWeights(before, light, samples, share);
#else
  precise vec4 sum = before + light * share;
#endif
  return sum;
}

void addLight(ivec2 pixel, vec4 light, int samples) {
  imageStore(sums, pixel, withLight(pixel, imageLoad(sums, pixel), light, samples));
}

// Returns the position (pixels) of sample s, or of the pixel's centre for s = -1.
vec2 shadingPlace(ivec2 pixel, int s) {
  ivec2 sixteenth = pixel * 16 + (s < 0 ? ivec2(8) : samplePlace(s));
  precise vec2 place = vec2(sixteenth) * 0.0625f;
  return place;
}
