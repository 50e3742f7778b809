// Averages the samples, lays them over the sky, then lens and film. SAMPLES: 1 or more.
#include "draw/frame_block.glsl"
#include "draw/sky.glsl"
#include "draw/film.glsl"
#if SAMPLES > 1
layout(binding = 0) uniform sampler2DMS scene;
#else
layout(binding = 0) uniform sampler2D scene;
#endif
in vec3 ray;
layout(location = 0) out vec4 pixel;

vec4 resolved(ivec2 at) {
#if SAMPLES > 1
  vec4 sum = texelFetch(scene, at, 0);
  for (int i = 1; i < SAMPLES; ++i) sum += texelFetch(scene, at, i);
  return sum / float(SAMPLES);
#else
  return texelFetch(scene, at, 0);
#endif
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 drawn = resolved(ivec2(at.x, int(frame.lens.w) - 1 - at.y));
  vec3 direction = normalize(ray);
  float glow = max(dot(direction, frame.sunDirection.xyz), 0.0);
  glow *= glow;
  glow *= glow;
  glow *= glow;
  vec3 light = drawn.rgb + (1.0 - drawn.a) * (skyRadiance(direction.y) +
                                             frame.sunLight.rgb * (frame.sunDirection.w * glow * glow));
  vec2 aside = gl_FragCoord.xy / frame.lens.zw * 2.0 - 1.0;
  light *= frame.lens.x * (1.0 - frame.lens.y * 0.5 * dot(aside, aside));
  pixel = vec4(encoded(filmed(light)) + dither(at), 1.0);
}
