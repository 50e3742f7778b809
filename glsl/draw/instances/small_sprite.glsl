// A sprite of few pixels, ready to be drawn, in four words. Graphics cards for computing give vertices and pixels a
// few of their processors only: kernels find place and light, shaders unpack them.
struct SmallSprite {
  vec3 place;  // clip coordinates over w, within -1 to 1
  float side;  // of the square, pixels (texels of the light's map)
  vec3 light;  // in the middle
  vec2 slope;  // fraction of it gained from the middle to the right, and to the top; within -1 to 1
};

// Three mantissas of 9 bits under the exponent of the largest.
uint packedLight(vec3 light) {
  float largest = max(max(light.r, light.g), max(light.b, 1e-9));
  int exponent = clamp(int(floor(log2(largest))) + 1, -15, 16);
  uvec3 m = uvec3(min(light * exp2(float(9 - exponent)) + 0.5, 511.0));
  return m.r | m.g << 9 | m.b << 18 | uint(exponent + 15) << 27;
}

vec3 unpackedLight(uint bits) {
  vec3 m = vec3(bits & 511u, bits >> 9 & 511u, bits >> 18 & 511u);
  return m * exp2(float(int(bits >> 27)) - 24.0);
}

// 20 bits for x and y, a 32nd of a pixel where a picture has 16384; 24 bits of depth.
uvec4 packedSprite(SmallSprite s) {
  uvec2 at = uvec2(clamp(s.place.xy * 0.5 + 0.5, 0.0, 1.0) * 1048575.0 + 0.5);
  uint depth = uint(clamp(s.place.z * 0.5 + 0.5, 0.0, 1.0) * 16777215.0 + 0.5);
  uint shape = packHalf2x16(vec2(s.side, 0)) & 0xffffu;
  return uvec4(at.x | at.y << 20, at.y >> 12 | depth << 8, shape | packSnorm4x8(vec4(0, 0, s.slope)) & 0xffff0000u,
               packedLight(s.light));
}

SmallSprite unpackedSprite(uvec4 words) {
  vec2 at = vec2(words.x & 0xfffffu, words.x >> 20 | (words.y & 0xffu) << 12);
  return SmallSprite(vec3(at / 1048575.0, float(words.y >> 8) / 16777215.0) * 2.0 - 1.0, unpackHalf2x16(words.z).x,
                     unpackedLight(words.w), unpackSnorm4x8(words.z).zw);
}
