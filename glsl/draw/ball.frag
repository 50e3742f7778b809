// A ball on the square of ball.vert. Variants of draw/lighting.glsl. SAMPLES: 1 or more.
#include "draw/frame_block.glsl"
#include "draw/lighting.glsl"
flat in vec3 tint;
flat in vec3 towards;
flat in vec3 bulge;
flat in vec3 placeBulge;
in vec3 across;
in vec3 worldPosition;
in vec3 place;
#if SAMPLES > 1
uniform vec2 sampleOffsets[SAMPLES];  // from the pixel's middle, in pixels
#endif
layout(location = 0) out vec4 radiance;

// Which samples lie inside the disk: its edge is as smooth as a mesh's.
int samplesInside() {
#if SAMPLES > 1
  vec3 alongX = dFdx(across), alongY = dFdy(across);
  int mask = 0;
  for (int i = 0; i < SAMPLES; ++i) {
    vec3 at = across + sampleOffsets[i].x * alongX + sampleOffsets[i].y * alongY;
    mask |= dot(at, at) < 1.0 ? 1 << i : 0;
  }
  return mask;
#else
  return dot(across, across) < 1.0 ? 1 : 0;
#endif
}

void main() {
  int inside = samplesInside();
  if (inside == 0) discard;
#if SAMPLES > 1
  gl_SampleMask[0] = inside;
#endif
  // From the square to the ball in front of it.
  float near = sqrt(max(1.0 - dot(across, across), 0.0));
  vec3 normal = normalize(across + near * towards);
  vec3 view = normalize(frame.eye.xyz - worldPosition - near * bulge);
  radiance = vec4(surfaceLight(tint, normal, view, sunShare(place + near * placeBulge)), 1.0);
}
