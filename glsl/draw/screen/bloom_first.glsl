// Writes the light above the bloom threshold at half the picture's size. SAMPLES: samples per pixel, 1 or more.
#include "draw/samples.glsl"
#include "draw/screen/screen.glsl"
layout(binding = sceneUnit) uniform SAMPLED scene;
uniform ivec2 size;  // size of the scene in pixels
uniform float threshold;

vec3 above(ivec2 at) {
  at = min(at, size - 1);
  vec3 light = vec3(0);
  // Clamps each sample to the half-float range, because infinite light would spread over the whole picture.
  for (int i = 0; i < SAMPLES; ++i) light += min(texelFetch(scene, at, SAMPLE(i)).rgb, 6e4);
  light /= float(SAMPLES);
  float brightest = max(light.r, max(light.g, light.b));
  return light * (max(brightest - threshold, 0.0) / max(brightest, 1e-6));
}

void main() {
  ivec2 at = 2 * ivec2(PIXEL);
  vec3 sum = above(at) + above(at + ivec2(1, 0)) + above(at + ivec2(0, 1)) + above(at + ivec2(1, 1));
  PUT(vec4(0.25 * sum, 1.0));
}
