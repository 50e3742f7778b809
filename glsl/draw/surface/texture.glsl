// A material's texture, by uv or from three sides (three_sides.glsl), and the relief that its brightness makes. TRIPLANAR, BUMPED.
layout(binding = albedoUnit) uniform sampler2D albedo;

// The texture where `shift` pixels to the right and up see it.
vec3 textureAt(vec2 place, vec2 shift) {
  return texture(albedo, place + dFdx(place) * shift.x + dFdy(place) * shift.y).rgb;
}

// Texels that a pixel covers of a place in uv.
float texelsAcross(vec2 place) {
  vec2 size = vec2(textureSize(albedo, 0));
  vec2 across = dFdx(place) * size, down = dFdy(place) * size;
  return sqrt(max(dot(across, across), dot(down, down)));
}

#ifdef TRIPLANAR
uniform vec2 perMetre;  // repeats
float texelsAPixel() {
  ThreeSides three = threeSides();
  return dot(three.weight, vec3(texelsAcross(three.x * perMetre), texelsAcross(three.y * perMetre), texelsAcross(three.z * perMetre)));
}
vec3 textureColor(vec2 shift) {
  ThreeSides three = threeSides();
  return three.weight.x * textureAt(three.x * perMetre, shift) + three.weight.y * textureAt(three.y * perMetre, shift) +
         three.weight.z * textureAt(three.z * perMetre, shift);
}
#else
in vec2 uv;
float texelsAPixel() {
  return texelsAcross(uv);
}
vec3 textureColor(vec2 shift) {
  return textureAt(uv, shift);
}
#endif

#ifdef BUMPED
float brightness(vec3 color) {
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

// The normal n of the surface raised by a height: n - grad height, from its changes over a pixel (Mikkelsen, "Bump Mapping
// Unparametrized Surfaces on the GPU", 2010), or over a texel where that is more: between texels the texture is linear,
// and its slope jumps at each of them. `bump`: height of white, m.
vec3 raisedNormal(vec3 normal, vec3 p, float bump) {
  vec3 across = dFdx(p), down = dFdy(p);
  vec3 first = cross(down, normal), second = cross(normal, across);
  float area = dot(across, first), pixels = 1.0 / clamp(texelsAPixel(), 0.02, 1.0), aside = 0.5 * pixels;
  float toRight = brightness(textureColor(vec2(aside, 0))) - brightness(textureColor(vec2(-aside, 0)));
  float up = brightness(textureColor(vec2(0, aside))) - brightness(textureColor(vec2(0, -aside)));
  vec3 rise = sign(area) * (bump / pixels) * (toRight * first + up * second);
  return normalize(abs(area) * normal - rise);
}
#endif
