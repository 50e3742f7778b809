// Shades the ground. The colour is premultiplied by alpha, so that the tone mapping pass can composite it over the sky.
// Defines: SHADOWED, GROUND_REFLECTIVE, LAMPS.
#include "draw/fragment_frame.glsl"
#include "draw/surface/ground_light.glsl"
#ifdef SHADOWED
#include "draw/surface/shadow_read.glsl"
in vec3 place;
#endif
in vec3 worldPosition;
layout(location = 0) out vec4 radiance;

void main() {
#ifdef SHADOWED
  float fraction = sunFraction(place);
#else
  const float fraction = 1.0;
#endif
  radiance = groundLight(worldPosition, normalize(frame.eye.xyz - frame.eye.w * worldPosition), fraction, 1.0);
}
