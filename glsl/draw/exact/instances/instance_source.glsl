// Reads instances by index, for the exact rasterizer.
#include "draw/instances/instance.glsl"
uniform int capacity;
int capacity_ = once(capacity);
uniform uint firstId;  // primitive id of the first instance
uint firstId_ = once(firstId);

// Returns the radius of the instance's bounding sphere (m); 0 if the instance is not shown.
float radiusOf(vec4 position, vec4 velocity) {
  precise float radius = instanceSize(position.w) * shapeRadius_;
  return isShown(position, velocity) && isNumber(radius) ? max(radius, 0.0f) : 0.0f;
}
