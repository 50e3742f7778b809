// Shades the ground tile by tile. Defines: SAMPLES, SHADOWED (with SHADOW_TAPS), GROUND_REFLECTIVE, LAMPS, OCCLUSION,
// REFLECTED, RAYS.
#define EXACT_PICTURE
#define GROUND_MIRROR
#define FADES
#if !defined REFLECTED && !defined RAYS
#define PIXEL_EXTENT
#endif
#include "draw/exact/tiles/shaded_tile.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/occlusion/openness_read.glsl"
#include "draw/exact/reflections/reflections_read.glsl"
#ifdef PIXEL_EXTENT
#include "draw/exact/shadows/pixel_extent.glsl"
#endif
#include "draw/surface/ground_light.glsl"
#include "draw/exact/haze.glsl"
#ifdef REFLECTED
#include "draw/exact/tiles/half_tile.glsl"
#endif
#ifdef SHADOWED
#include "draw/exact/shadows/sun_map.glsl"
#endif
#ifdef RAYS
#include "draw/exact/rays/spots.glsl"
#include "draw/exact/rays/ground_ray.glsl"
#endif

int samplesOfGround(ivec2 pixel) {
  PixelIds shown = idsOf(pixel);
  int samples = 0;
  for (int s = 0; s < SAMPLES; ++s) samples |= shown.of[s] == groundId ? 1 << s : 0;
  return samples;
}

vec4 groundThroughHaze(vec4 light, vec3 p) {
#ifdef HAZE
  return vec4(throughHaze(light.rgb, light.a, p), light.a);
#else
  return light;
#endif
}

// Returns the ground's light in a pixel. `samples` is the mask of the samples that show the ground.
vec4 lightGround(ivec2 pixel, int samples) {
  int first = findLSB(samples);
  vec3 ray = rayThrough(shadingPlace(pixel, -1));
  float depth = groundDepth(ray);
  if (depth < view.near) {
    ray = rayThrough(shadingPlace(pixel, first));
    depth = groundDepth(ray);
  }
  vec3 p = placeOnRay(ray, depth);
#ifdef PIXEL_EXTENT
  pixelAlong = groundExtent(directionOf(ray), depth);
#endif
#ifdef SHADOWED
  float fraction = sunFraction(lightPlace(p), vec3(0, 1, 0));
#else
  const float fraction = 1.0f;
#endif
#ifdef RAYS
  float alpha = groundAlpha(p);
  keepSpot(firstSample(pixel) + first, p, vec3(0, 1, 0), vec3(0, 1, 0), frame.groundColor.rgb,
           vec3(frame.groundRoughness, 0.0f, 0.0f), alpha);
  return groundThroughHaze(vec4(0.0f, 0.0f, 0.0f, alpha), p);
#endif
  precise vec3 towards = -directionOf(ray);
#ifdef REFLECTED
  facing_ = vec3(0, 1, 0);
  vec3 eyewards = unitOf(towards);
  vec4 met = vec4(0.0f), light = vec4(0.0f);
  // A ray that misses the ground may see the sky. It gets no reflection.
  IF_ANY(depth >= view.near)
    met = lightMet(p, vec3(-eyewards.x, abs(eyewards.y), -eyewards.z), -1.0f, eyewards, frame.groundRoughness);
  IF_ANY(met.w > 0.0f) light = groundReflected(p, eyewards, met, opennessOn(pixel, p));
  return groundThroughHaze(light, p);
#endif
#ifdef SHOWN
  float there = groundLight(p, unitOf(towards), fraction, 1.0f).a;
  precise vec3 value = (SHOWN == 1 ? vec3(0, 1, 0) : SHOWN == 2 ? frame.groundColor.rgb : vec3(0)) * there;
  return vec4(value, there);
#endif
  return groundThroughHaze(groundLight(p, unitOf(towards), fraction, opennessOn(pixel, p)), p);
}

void main() {
  ivec2 corner = tileToShade();
  if (corner.x < 0) return;
#ifdef REFLECTED
  // The reflection is computed once for the four pixels of a half pixel. A tile equals a cell of level 2. If that cell
  // is empty, all samples of the tile show the ground.
  bool clear = nearestAt(2 + refined_, ivec2(corner.x >> 3, corner.y >> 3)) == 0.0f;
  int traced = halfPixelsToTrace(corner);
  for (int ray = int(gl_LocalInvocationIndex); ray < raysToTrace(traced); ray += 64 / ROWS) {
    ivec2 item = rayToTrace(traced, ray);
    int i = item.x;
    ivec4 samples = ivec4(0);
    for (int k = 0; k < 4; ++k) {
      ivec2 pixel = pixelOfHalf(corner, i, k);
      if (inPicture(pixel) && (item.y >> k & 1) != 0) samples[k] = clear ? (1 << SAMPLES) - 1 : 0;
    }
    for (int k = clear ? 4 : 0; k < 4; ++k) {
      ivec2 pixel = pixelOfHalf(corner, i, k);
      if (inPicture(pixel) && (item.y >> k & 1) != 0) samples[k] = samplesOfGround(pixel);
    }
    if ((samples.x | samples.y | samples.z | samples.w) == 0) continue;
    int k = firstOf(samples);
    addToHalf(corner, i, lightGround(pixelOfHalf(corner, i, k), samples[k]), samples, groundId);
  }
#else
  for (int i = 0; i < ROWS; ++i) {
    ivec2 pixel = pixelOf(corner, i);
    int samples = inPicture(pixel) ? samplesOfGround(pixel) : 0;
    if (samples != 0) addLight(pixel, lightGround(pixel, samples), samples);
  }
#endif
}
