// Averages the samples of each pixel, composites them over the sky, and applies lens and film. SAMPLES: samples per
// pixel, 1 or more. BLOOM: adds the bloom texture.
#include "draw/fragment_frame.glsl"
#include "draw/samples.glsl"
#include "draw/sky.glsl"
#include "draw/screen/film.glsl"
#include "draw/screen/lens.glsl"
#include "draw/screen/screen.glsl"
layout(binding = sceneUnit) uniform SAMPLED scene;
#ifdef BLOOM
layout(binding = bloomUnit) uniform sampler2D scattered;  // bloom texture at half the picture's size
uniform float bloomStrength;
#endif
#ifndef KERNEL
in vec3 ray;
#endif

vec4 resolved(ivec2 at) {
#if SAMPLES > 1
  vec4 sum = texelFetch(scene, at, 0);
  for (int i = 1; i < SAMPLES; ++i) sum += texelFetch(scene, at, i);
  sum /= float(SAMPLES);
  return min(sum, 6e4);  // limits the light, because the sum of glows may exceed the half-float range
#else
  return min(texelFetch(scene, at, 0), 6e4);
#endif
}

void main() {
#ifdef KERNEL
  vec2 onPicture = PIXEL / frame.size * 2.0 - 1.0;
  vec3 ray = frame.rayForward.xyz + frame.rayRight.xyz * onPicture.x - frame.rayUp.xyz * onPicture.y;
#endif
  ivec2 at = ivec2(PIXEL);
  vec4 drawn = resolved(ivec2(at.x, int(frame.size.y) - 1 - at.y));
  vec3 direction = normalize(ray);
  vec3 light = drawn.rgb + (1.0 - drawn.a) * skyInDirection(direction);
#ifdef BLOOM
  // Bloom level 0 has (size + 1) / 2 texels, each two pixels wide.
  vec2 place = vec2(PIXEL.x, frame.size.y - PIXEL.y) * 0.5 / vec2(textureSize(scattered, 0));
  light += bloomStrength * texture(scattered, place).rgb;
#endif
  PUT(vec4(encoded(filmed(throughLens(light, PIXEL / frame.size * 2.0 - 1.0))) + dither(at), 1.0));
}
