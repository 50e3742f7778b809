// Returns the fraction of a lamp's light that reaches a point, filtered over a few texels of the lamp's shadow maps.
#include "draw/lights/faces.glsl"
layout(binding = lampShadowUnit) uniform sampler2DShadow lampShadows;

// Returns the fraction of the lamp's light. `nl` is the cosine between the normal and the direction to the lamp. The
// lookup point is offset to the lit side of the surface so that the surface does not shadow itself.
float lampFraction(int lamp, vec3 from, vec3 normal, float nl) {
  vec4 maps = lampMaps(lamp), sampling = lampSampling(lamp);
  vec3 a = abs(from);
  float texel = sampling.y * max(a.x, max(a.y, a.z));
  from += normal * (clamp(4.0 * nl, -1.0, 1.0) * texel * (0.5 + 0.5 * sampling.z));
  int face = faceOf(from);
  vec3 q = onFace(face, from);
  vec2 place = maps.xy * (vec2(float(face) + 0.5, 0.5) + (0.5 * maps.w / q.x) * q.yz) + vec2(0, maps.z);
  float depth = clamp(faceDepth(q.x, sampling.x), 0.0, 1.0);
  vec2 radius = maps.xy * (sampling.z * sampling.w);
#if LAMP_TAPS == 4
  // The four taps form a square turned by 27 degrees, as in the sun's shadow filter.
  vec2 u = radius * vec2(0.667, 0.333), v = radius * vec2(-0.333, 0.667);
  return 0.25 *
         (texture(lampShadows, vec3(place + u, depth)) + texture(lampShadows, vec3(place - u, depth)) +
          texture(lampShadows, vec3(place + v, depth)) + texture(lampShadows, vec3(place - v, depth)));
#else
  float sum = 0.0;
  for (int i = 0; i < LAMP_TAPS; ++i) {  // taps at points of a sunflower spiral on a disc
    float turn = 2.399963 * float(i);
    vec2 offset = radius * sqrt((float(i) + 0.5) / float(LAMP_TAPS)) * vec2(cos(turn), sin(turn));
    sum += texture(lampShadows, vec3(place + offset, depth));
  }
  return sum / float(LAMP_TAPS);
#endif
}
