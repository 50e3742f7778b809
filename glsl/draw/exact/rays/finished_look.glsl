// Adds the layers of the material table (coat, fibres, clear surface) to a facet.
#ifndef EXACT_RAY_FINISHED_LOOK
#define EXACT_RAY_FINISHED_LOOK
#include "draw/exact/rays/looks.glsl"

// Adds coat, fibres and clear surface. `smooth_` is the normal that points to the viewer's side, without relief.
Facet finishedFacet(Facet f, int owner, vec3 smooth_) {
  vec4 light = lookOf(owner, lightLook), layers = lookOf(owner, layerLook), sheen = lookOf(owner, sheenLook);
  f = withFibres(f, sheen.rgb, layers.y);
  return withCoat(f, smooth_, light.w, layers.x);
}
// Adds the clear surface. For a solid, the tint is the square root of the colour, because light passes two surfaces.
Facet glassFacet(Facet f, int owner, vec3 base, float metallic, bool inside) {
  vec4 glass = lookOf(owner, glassLook);
  bool thin = glass.y > 0.0f;
  vec3 tint = thin ? base : vec3(exactSqrt(base.x), exactSqrt(base.y), exactSqrt(base.z));
  return withGlass(f, lookOf(owner, sheenLook).w, metallic, glass.x, thin, inside, tint);
}
#endif
