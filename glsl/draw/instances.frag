// Instances as instances.vert lays them out. Variants: SPRITE, ADDITIVE, DEPTH_ONLY, and those of
// draw/lighting.glsl. SAMPLES: 1 or more.
#include "draw/frame_block.glsl"
#include "draw/lighting.glsl"
flat in vec3 tint;
#ifdef SPRITE
in vec3 across;
flat in vec3 towards;
#else
in vec3 worldNormal;
#endif
#ifndef DEPTH_ONLY
in vec3 worldPosition;
#ifdef SHADOW
in vec3 place;
#else
const vec3 place = vec3(0);
#endif
layout(location = 0) out vec4 radiance;
#endif
#if defined(SPRITE) && !defined(ADDITIVE) && SAMPLES > 1
uniform vec2 sampleOffsets[SAMPLES];  // from the pixel's middle, in pixels

// Samples inside the disk: as exact an edge as a mesh has.
int diskSamples() {
  vec3 alongX = dFdx(across), alongY = dFdy(across);
  int mask = 0;
  for (int i = 0; i < SAMPLES; ++i) {
    vec3 at = across + sampleOffsets[i].x * alongX + sampleOffsets[i].y * alongY;
    mask |= dot(at, at) < 1.0 ? 1 << i : 0;
  }
  return mask;
}
#endif

void main() {
#ifdef SPRITE
  float outside = dot(across, across);
#endif
#ifdef DEPTH_ONLY
#ifdef SPRITE
  if (outside > 1.0) discard;
#endif
#elif defined(ADDITIVE)
#ifdef SPRITE
  float inside = max(1.0 - outside, 0.0);
  radiance = vec4(tint * (inside * inside), 0.0);
#else
  radiance = vec4(tint, 0.0);
#endif
#else
#ifdef SPRITE
#if SAMPLES > 1
  int covered = diskSamples();
  if (covered == 0) discard;
  gl_SampleMask[0] = covered;
#else
  if (outside > 1.0) discard;
#endif
  vec3 normal = normalize(across + towards * sqrt(max(1.0 - outside, 0.0)));
#else
  vec3 normal = normalize(worldNormal);
#endif
  vec3 view = normalize(frame.eye.xyz - worldPosition);
  radiance = vec4(surfaceLight(tint, normal, view, sunShare(place)), 1.0);
#endif
}
