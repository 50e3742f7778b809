// A sprite of few pixels, ready to be drawn, in four words. Graphics cards for computing give vertices and pixels a
// few of their processors only: kernels find place and light, shaders unpack them.
#include "common/exact.glsl"
struct SmallSprite {
  vec3 place;  // clip coordinates over w, within -1 to 1
  float side;  // of the square, pixels (texels of the light's map)
  vec3 light;  // in the middle
  vec2 slope;  // fraction of it gained from the middle to the right, and to the top; within -1 to 1
};

// Three mantissas of 9 bits under the exponent of the largest.
uint packedLight(vec3 light) {
  float largest = max(max(light.r, light.g), max(light.b, 1e-9));
  int exponent = clamp((floatBitsToInt(largest) >> 23) - 126, -15, 16);  // of the power of two above it
  precise vec3 steps = light * intBitsToFloat((136 - exponent) << 23) + 0.5;
  uvec3 m = uvec3(min(steps, 511.0));
  return m.r | m.g << 9 | m.b << 18 | uint(exponent + 15) << 27;
}

vec3 unpackedLight(uint bits) {
  vec3 m = vec3(bits & 511u, bits >> 9 & 511u, bits >> 18 & 511u);
  precise vec3 light = m * intBitsToFloat((int(bits >> 27) + 103) << 23);
  return light;
}

// 20 bits for x and y, a 32nd of a pixel where a picture has 16384; 24 bits of depth.
uvec4 packedSprite(SmallSprite s) {
  precise vec3 place = s.place * 0.5 + 0.5;
  place = clamp(place, 0.0, 1.0) * vec3(1048575.0, 1048575.0, 16777215.0) + 0.5;
  uint depth = uint(min(place.z, 16777215.0));
  uvec2 at = uvec2(place.xy);
  uint shape = packHalf2x16(vec2(s.side, 0)) & 0xffffu;
  precise vec2 slope = clamp(s.slope, -1.0, 1.0) * 127.0 + 127.5;
  uvec2 steps = uvec2(slope);
  return uvec4(at.x | at.y << 20, at.y >> 12 | depth << 8, shape | steps.x << 16 | steps.y << 24,
               packedLight(s.light));
}

SmallSprite unpackedSprite(uvec4 words) {
  vec2 at = vec2(words.x & 0xfffffu, words.x >> 20 | (words.y & 0xffu) << 12);
  precise vec3 place = vec3(at, float(words.y >> 8)) * vec3(1.90735045e-6, 1.90735045e-6, 1.19209297e-7) - 1.0;
  vec2 steps = vec2(words.z >> 16 & 0xffu, words.z >> 24);
  precise vec2 slope = (steps - 127.0) * 7.8740157e-3;
  return SmallSprite(place, unpackHalf2x16(words.z).x, unpackedLight(words.w), slope);
}
