// Light of the ground on its tiles. Variants: SHADOWED (with SHADOW_TAPS), REFLECTIVE, LAMPS, OCCLUSION, REFLECTED, RAYS. SAMPLES.
#define EXACT_PICTURE
#include "draw/exact/tiles/shaded_tile.glsl"
#include "draw/exact/ground_plane.glsl"
#include "draw/exact/occlusion/openness_read.glsl"
#include "draw/exact/reflections/reflections_read.glsl"
#include "draw/surface/ground_light.glsl"
#ifdef SHADOWED
#include "draw/exact/shadows/sun_map.glsl"
#endif
#ifdef RAYS
#include "draw/exact/rays/spots.glsl"
#include "draw/exact/rays/ground_ray.glsl"
#endif

void lightGround(ivec2 pixel) {
  PixelIds shown = idsOf(pixel);
  int samples = 0, first = 0;
  for (int s = SAMPLES - 1; s >= 0; --s)
    if (shown.of[s] == groundId) {
      samples |= 1 << s;
      first = s;
    }
  if (samples == 0) return;
  vec3 ray = rayThrough(shadingPlace(pixel, -1));
  float depth = groundDepth(ray);
  if (depth < view.near) {
    ray = rayThrough(shadingPlace(pixel, first));
    depth = groundDepth(ray);
  }
  vec3 p = placeOnRay(ray, depth);
#ifdef SHADOWED
  float fraction = sunFraction(lightPlace(p), vec3(0, 1, 0));
#else
  const float fraction = 1.0f;
#endif
#ifdef RAYS
  float alpha = groundAlpha(p);
  keepSpot(firstSample(pixel) + first, p, vec3(0, 1, 0), vec3(0, 1, 0), frame.groundColor.rgb,
           vec3(frame.groundRoughness, 0.0f, 0.0f), alpha);
  addLight(pixel, vec4(0.0f, 0.0f, 0.0f, alpha), samples);
  return;
#endif
  precise vec3 towards = -directionOf(ray);
#ifdef REFLECTED
  facing_ = vec3(0, 1, 0);
#endif
#ifdef SHOWN
  float there = groundLight(p, unitOf(towards), fraction, 1.0f).a;
  precise vec3 value = (SHOWN == 1 ? vec3(0, 1, 0) : frame.groundColor.rgb) * there;
  addLight(pixel, vec4(value, there), samples);
  return;
#endif
  addLight(pixel, groundLight(p, unitOf(towards), fraction, opennessOn(pixel, p)), samples);
}

void main() {
  ivec2 corner = tileToShade();
  if (corner.x < 0) return;
  for (int i = 0; i < ROWS; ++i) {
    ivec2 pixel = pixelOf(corner, i);
    if (inPicture(pixel)) lightGround(pixel);
  }
}
