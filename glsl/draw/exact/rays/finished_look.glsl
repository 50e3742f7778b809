// Facets with what the table of looks says that lies over them, and what goes through.
#ifndef EXACT_RAY_FINISHED_LOOK
#define EXACT_RAY_FINISHED_LOOK
#include "draw/exact/rays/looks.glsl"

// `smooth_`: the normal on the side that is seen, without relief; `metallic`: of the place.
Facet finishedFacet(Facet f, int owner, vec3 smooth_) {
  vec4 light = lookOf(owner, lightLook), layers = lookOf(owner, layerLook), sheen = lookOf(owner, sheenLook);
  f = withFibres(f, sheen.rgb, layers.y);
  return withCoat(f, smooth_, light.w, layers.x);
}
// A solid's two surfaces together tint light by its colour.
Facet glassFacet(Facet f, int owner, vec3 base, float metallic, bool inside) {
  vec4 glass = lookOf(owner, glassLook);
  bool thin = glass.y > 0.0f;
  vec3 tint = thin ? base : vec3(exactSqrt(base.x), exactSqrt(base.y), exactSqrt(base.z));
  return withGlass(f, lookOf(owner, sheenLook).w, metallic, glass.x, thin, inside, tint);
}
#endif
