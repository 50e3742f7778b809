// Colour of a material's texture, by uv. TRIPLANAR: projected along three axes (three_sides.glsl) instead. BUMPED: also
// computes the bump relief from the texture's brightness.
#include "draw/surface/footprint.glsl"
layout(binding = albedoUnit) uniform sampler2D albedo;

// Returns the texture's colour at the point that is `shift` pixels to the right and up. Uses the same taps as the exact
// rasterizer, because drivers differ in their anisotropic filtering or have none.
vec3 textureAt(vec2 place, vec2 shift) {
  Seen seen = Seen(place, dFdx(place), dFdy(place));
  TextureShape shape = TextureShape(textureSize(albedo, 0), textureQueryLevels(albedo), ivec2(WRAP_REPEAT));
  Footprint print = footprintOf(seen, shape);
  vec2 middle = place + seen.across * shift.x + seen.up * shift.y;
  vec3 sum = vec3(0);
  for (int i = 0; i < print.taps; ++i) {
    float aside = (float(i) + 0.5) * perTap(print.taps) - 0.5;
    sum += textureLod(albedo, middle + print.along * aside, float(print.level) + print.part).rgb;
  }
  return sum * perTap(print.taps);
}

// Returns the number of texels that a pixel at a uv position spans.
float texelsAcross(vec2 place) {
  vec2 size = vec2(textureSize(albedo, 0));
  vec2 across = dFdx(place) * size, down = dFdy(place) * size;
  return sqrt(max(dot(across, across), dot(down, down)));
}

#ifdef TRIPLANAR
uniform vec2 perMetre;  // repeats of the texture per metre
float texelsAPixel() {
  ThreeSides three = threeSides(objectPosition, objectNormal);
  return dot(three.weight, vec3(texelsAcross(three.x * perMetre), texelsAcross(three.y * perMetre), texelsAcross(three.z * perMetre)));
}
vec3 textureColor(vec2 shift) {
  ThreeSides three = threeSides(objectPosition, objectNormal);
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
#include "draw/surface/raised_normal.glsl"
// Returns the normal, tilted by the relief. `bump` is the height of white in the texture (m).
vec3 bumpedNormal(vec3 normal, vec3 p, float bump) {
  float aside = pixelsAside(texelsAPixel());
  vec2 rises = vec2(brightness(textureColor(vec2(aside, 0))) - brightness(textureColor(vec2(-aside, 0))),
                    brightness(textureColor(vec2(0, aside))) - brightness(textureColor(vec2(0, -aside))));
  return raisedNormal(normal, dFdx(p), dFdy(p), rises * (0.5 * bump / aside));
}
#endif
