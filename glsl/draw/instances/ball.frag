// Shades a ball on the square of ball.vert. SAMPLES: samples per pixel, 1 or more. Defines: as for
// draw/surface/lighting.glsl.
#include "draw/frame_block.glsl"
#include "draw/surface/material.glsl"
#include "draw/surface/shadow_read.glsl"
flat in vec3 tint;
flat in vec3 middle;
flat in vec2 radii;
in vec3 worldPosition;
in vec3 place;
in vec3 placeRay;
#if SAMPLES > 1
uniform vec2 sampleOffsets[SAMPLES];  // offset of each sample from the pixel's centre, in pixels
#endif
layout(location = 0) out vec4 radiance;

// Returns the bit mask of the samples inside the ball's outline, so that the edge is as smooth as a mesh's edge.
int samplesInside(vec3 across) {
#if SAMPLES > 1
  vec3 alongX = dFdx(across), alongY = dFdy(across);
  int mask = 0;
  for (int i = 0; i < SAMPLES; ++i) {
    vec3 at = across + sampleOffsets[i].x * alongX + sampleOffsets[i].y * alongY;
    mask |= dot(at, at) < radii.y * radii.y ? 1 << i : 0;
  }
  return mask;
#else
  return dot(across, across) < radii.y * radii.y ? 1 : 0;
#endif
}

void main() {
  vec3 across = worldPosition - middle;
  int inside = samplesInside(across);
  if (inside == 0) discard;
#if SAMPLES > 1
  gl_SampleMask[0] = inside;
#endif
  // Intersects the ray from the eye through this point of the square with the ball: solves |across + t ray| = radius
  // for t.
  vec3 ray = frame.eye.w * worldPosition - frame.eye.xyz;
  float rr = dot(ray, ray), b = dot(across, ray);
  float t = -(b + sqrt(max(b * b - rr * (dot(across, across) - radii.x * radii.x), 0.0))) / rr;
  vec3 outwards = across + t * ray;
  vec3 normal = normalize(outwards);
  vec3 view = -ray * inversesqrt(rr);
  radiance = vec4(allLight(lookOf(tint), middle + outwards, normal, view, sunFraction(place + t * placeRay)), 1.0);
}
