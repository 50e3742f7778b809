// Fraction of the sun that reaches a place, filtered over frame.shadowSoftness texels of the sun's map. SHADOW_TAPS.
#include "draw/exact/bindings.glsl"
#include "draw/exact/light_place.glsl"
#include "draw/exact/triangle.glsl"
layout(binding = mapUnit) uniform usamplerBuffer sunMap;

// Lit texels around a place (texels), weighted linearly.
float litAround(vec2 place, uint key, int side) {
  precise vec2 corner = place - 0.5f;
  precise vec2 whole = floor(corner);
  precise vec2 part = corner - whole;
  ivec2 first = clamp(ivec2(whole), ivec2(0), ivec2(side - 1));
  ivec2 second = clamp(ivec2(whole) + 1, ivec2(0), ivec2(side - 1));
  float a = key <= texelFetch(sunMap, first.y * side + first.x).x ? 1.0f : 0.0f;
  float b = key <= texelFetch(sunMap, first.y * side + second.x).x ? 1.0f : 0.0f;
  float c = key <= texelFetch(sunMap, second.y * side + first.x).x ? 1.0f : 0.0f;
  float d = key <= texelFetch(sunMap, second.y * side + second.x).x ? 1.0f : 0.0f;
  precise float upper = a + (b - a) * part.x;
  precise float lower = c + (d - c) * part.x;
  precise float lit = upper + (lower - upper) * part.y;
  return lit;
}

float sunFraction(vec3 place) {
  int side = int(frame.shadowTexels);
  precise float near = 1.0f - place.z;
  uint key = nearKey(max(near, 0.0f));  // behind every caster still counts as inside the map
  precise vec2 middle = place.xy * frame.shadowTexels;
  float radius = frame.shadowSoftness;
#if SHADOW_TAPS == 4
  // A square turned by 27 degrees: with bilinear taps its steps overlap into a smooth ramp.
  precise vec2 u = radius * vec2(0.667f, 0.333f);
  precise vec2 v = radius * vec2(-0.333f, 0.667f);
  precise vec2 first = middle + u;
  precise vec2 second = middle - u;
  precise vec2 third = middle + v;
  precise vec2 fourth = middle - v;
  precise float sum = litAround(first, key, side) + litAround(second, key, side) + litAround(third, key, side) +
                      litAround(fourth, key, side);
  precise float fraction = 0.25f * sum;
#else
  precise float sum = 0.0f;
  for (int i = 0; i < SHADOW_TAPS; ++i) {  // sunflower disc
    precise float turn = 2.399963f * float(i);
    precise float far = (float(i) + 0.5f) * 0.0625f;
    precise float along = radius * exactSqrt(far);
    precise vec2 tap = middle + along * vec2(exactCos(turn), exactSin(turn));
    sum = sum + litAround(tap, key, side);
  }
  precise float fraction = sum * 0.0625f;  // sixteen
#endif
  return fraction;
}

// A step to the lit side of a surface: looked up there, it does not shade itself.
float sunFractionOn(vec3 p, vec3 normal) {
  precise float turned = 4.0f * exactDot(normal, frame.sunDirection.xyz);
  precise float lift = clamp(turned, -1.0f, 1.0f) * lightTexel() * (0.5f + 0.5f * frame.shadowSoftness);
  precise vec3 lifted = p + normal * lift;
  return sunFraction(lightPlace(lifted));
}
