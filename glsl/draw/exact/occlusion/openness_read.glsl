// Returns the ambient occlusion of shaded points. Without OCCLUSION the openness is 1 everywhere.
#ifdef OCCLUSION
#include "draw/exact/bindings.glsl"
layout(rg32f, binding = opennessImage) readonly restrict uniform imageBuffer openness;

vec2 opennessAt(ivec2 at) {
  return imageLoad(openness, at.y * ((view.size.x + 1) / 2) + at.x).xy;
}
#include "draw/exact/occlusion/open_place.glsl"
#else
float opennessOn(ivec2 pixel, vec3 p) {
  return 1.0f;
}
#endif
