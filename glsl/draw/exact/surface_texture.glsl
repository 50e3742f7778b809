// A material's texture on a spot of a surface (surface_seen.glsl); BUMPED by the relief of its brightness.
#include "draw/exact/texture_read.glsl"
#include "draw/surface/raised_normal.glsl"
#ifdef TRIPLANAR
// Nothing where nothing of it shows: most walls and floors face one side.
vec3 sideColor(float weight, Seen seen, vec2 shift) {
  vec3 color = vec3(0);
  if (weight > 0.0f) color = textureSeen(seen, shift);
  return color;
}
vec3 textureColor(SurfaceSeen seen, vec2 shift) {
  vec3 w = seen.weight;
  vec3 x = sideColor(w.x, seen.x, shift), y = sideColor(w.y, seen.y, shift), z = sideColor(w.z, seen.z, shift);
  precise vec3 mean = w.x * x + w.y * y + w.z * z;
  return mean;
}
float texelsOf(SurfaceSeen seen) {
  return exactDot(seen.weight, vec3(texelsAPixel(seen.x), texelsAPixel(seen.y), texelsAPixel(seen.z)));
}
#else
vec3 textureColor(SurfaceSeen seen, vec2 shift) {
  return textureSeen(seen, shift);
}
float texelsOf(SurfaceSeen seen) {
  return texelsAPixel(seen);
}
#endif

#ifdef BUMPED
uniform float bump;  // height of white, m

vec3 bumpedNormal(SurfaceSeen seen, Spot spot, vec3 normal) {
  float aside = pixelsAside(texelsOf(seen));
  precise float perPixel = 0.5f * bump * exactReciprocal(aside);
  precise float across = brightness(textureColor(seen, vec2(aside, 0))) - brightness(textureColor(seen, vec2(-aside, 0)));
  precise float up = brightness(textureColor(seen, vec2(0, aside))) - brightness(textureColor(seen, vec2(0, -aside)));
  precise vec2 rises = vec2(across, up) * perPixel;
  precise vec3 right = planePlace(spot, vec2(1, 0)) - spot.place;
  precise vec3 above = planePlace(spot, vec2(0, -1)) - spot.place;
  return raisedNormal(normal, right, above, rises);
}
#endif
