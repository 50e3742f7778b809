// A sprite of a few pixels, packed into four words. Compute GPUs use only a few of their processors for vertex and
// fragment shaders. A kernel therefore computes position and light, and the draw shaders only unpack them.
#include "common/exact.glsl"
struct SmallSprite {
  vec3 place;  // position: clip coordinates divided by w, -1 to 1
  float side;  // side of the square in pixels (texels of the shadow map for FOR_LIGHT)
  vec3 light;  // light at the sprite's centre
  vec2 slope;  // relative change of light (-1 to 1) from the centre to the right edge and to the top edge
};

// Packs a light value as three 9-bit mantissas with a shared exponent.
uint packedLight(vec3 light) {
  float largest = max(max(light.r, light.g), max(light.b, 1e-9));
  // Exponent of the smallest power of two above the largest component.
  int exponent = clamp((floatBitsToInt(largest) >> 23) - 126, -15, 16);
  precise vec3 steps = light * intBitsToFloat((136 - exponent) << 23) + 0.5;
  uvec3 m = uvec3(min(steps, 511.0));
  return m.r | m.g << 9 | m.b << 18 | uint(exponent + 15) << 27;
}

vec3 unpackedLight(uint bits) {
  vec3 m = vec3(bits & 511u, bits >> 9 & 511u, bits >> 18 & 511u);
  precise vec3 light = m * intBitsToFloat((int(bits >> 27) + 103) << 23);
  return light;
}

// Packs a sprite. x and y have 20 bits each (1/64 pixel in a picture of 16384 pixels); the depth has 24 bits.
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
