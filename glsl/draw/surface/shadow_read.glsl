// Returns the fraction of sunlight that reaches a point of the shadow map, filtered over frame.shadowSoftness texels.
#include "draw/bindings.glsl"
#ifdef SHADOW
layout(binding = shadowUnit) uniform sampler2DShadow shadowMap;

float sunFraction(vec3 place) {
  float depth = min(place.z, 1.0);  // limits the depth so that a point behind every caster counts as inside the map
  float radius = frame.shadowSoftness / frame.shadowTexels;
#if SHADOW_TAPS == 4
  // The four taps form a square turned by 27 degrees. With bilinear taps, their steps form a smooth ramp.
  vec2 a = radius * vec2(0.667, 0.333), b = radius * vec2(-0.333, 0.667);
  return 0.25 * (texture(shadowMap, vec3(place.xy + a, depth)) + texture(shadowMap, vec3(place.xy - a, depth)) +
                 texture(shadowMap, vec3(place.xy + b, depth)) + texture(shadowMap, vec3(place.xy - b, depth)));
#else
  float sum = 0.0;
  for (int i = 0; i < SHADOW_TAPS; ++i) {  // taps at points of a sunflower spiral on a disc
    float turn = 2.399963 * float(i);
    vec2 offset = radius * sqrt((float(i) + 0.5) / float(SHADOW_TAPS)) * vec2(cos(turn), sin(turn));
    sum += texture(shadowMap, vec3(place.xy + offset, depth));
  }
  return sum / float(SHADOW_TAPS);
#endif
}
#else
float sunFraction(vec3 place) {
  return 1.0;
}
#endif
