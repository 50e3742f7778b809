// Quantization grid for the boxes of a hierarchy, computed from the bounds of the whole scene.
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/ray_box.glsl"
#include "draw/ordered_key.glsl"
// Bounding box of the scene as six keys: low x, y, z, then high x, y, z.
layout(std430, binding = rayBoundsBinding) readonly restrict buffer BoundsBlock { uint bounds[]; };
vec3 lowBound() {
  return vec3(fromOrderedKey(bounds[0]), fromOrderedKey(bounds[1]), fromOrderedKey(bounds[2]));
}
vec3 highBound() {
  return vec3(fromOrderedKey(bounds[3]), fromOrderedKey(bounds[4]), fromOrderedKey(bounds[5]));
}
RayGrid gridOfAll() {
  vec3 low = lowBound(), high = highBound();
  bool any_ = low.x <= high.x;
  return rayGrid(any_ ? low : vec3(0), any_ ? high : vec3(0));
}
