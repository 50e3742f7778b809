// Fraction of a light that reaches a place of its shadow map, filtered over a few texels, by reads of our own.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangle.glsl"

// Where a map lies among keys.
struct ShadowMap {
  int side;    // texels
  int first;   // its first key,
  int stride;  // and how many there are from a row to the next
};

// Lit texels around a place (texels), weighted linearly.
float litAround(usamplerBuffer keys, ShadowMap map, vec2 place, uint key) {
  precise vec2 corner = place - 0.5f;
  precise vec2 whole = floor(corner);
  precise vec2 part = corner - whole;
  ivec2 a = clamp(ivec2(whole), ivec2(0), ivec2(map.side - 1));
  ivec2 b = clamp(ivec2(whole) + 1, ivec2(0), ivec2(map.side - 1));
  int upperRow = map.first + a.y * map.stride, lowerRow = map.first + b.y * map.stride;
  float p = key <= texelFetch(keys, upperRow + a.x).x ? 1.0f : 0.0f;
  float q = key <= texelFetch(keys, upperRow + b.x).x ? 1.0f : 0.0f;
  float r = key <= texelFetch(keys, lowerRow + a.x).x ? 1.0f : 0.0f;
  float s = key <= texelFetch(keys, lowerRow + b.x).x ? 1.0f : 0.0f;
  precise float upper = p + (q - p) * part.x;
  precise float lower = r + (s - r) * part.x;
  precise float lit = upper + (lower - upper) * part.y;
  return lit;
}

// Four taps: a square turned by 27 degrees, whose steps overlap into a smooth ramp.
float litByFour(usamplerBuffer keys, ShadowMap map, vec2 middle, uint key, float radius) {
  precise vec2 u = radius * vec2(0.667f, 0.333f);
  precise vec2 v = radius * vec2(-0.333f, 0.667f);
  precise vec2 one = middle + u;
  precise vec2 two = middle - u;
  precise vec2 three = middle + v;
  precise vec2 four = middle - v;
  precise float sum = litAround(keys, map, one, key) + litAround(keys, map, two, key) + litAround(keys, map, three, key) +
                      litAround(keys, map, four, key);
  precise float fraction = 0.25f * sum;
  return fraction;
}

// Sixteen: a sunflower disc.
float litBySixteen(usamplerBuffer keys, ShadowMap map, vec2 middle, uint key, float radius) {
  precise float sum = 0.0f;
  for (int i = 0; i < 16; ++i) {
    precise float turn = 2.399963f * float(i);
    precise float far = (float(i) + 0.5f) * 0.0625f;
    precise float along = radius * exactSqrt(far);
    precise vec2 tap = middle + along * vec2(exactCos(turn), exactSin(turn));
    sum = sum + litAround(keys, map, tap, key);
  }
  precise float fraction = sum * 0.0625f;
  return fraction;
}
