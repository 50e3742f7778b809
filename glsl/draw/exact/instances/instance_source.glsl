// Instances by number.
#include "draw/instances/instance.glsl"
uniform int capacity;
int capacity_ = once(capacity);
uniform uint firstId;  // of the first one's number
uint firstId_ = once(firstId);

// Of a ball around it (m); 0 for one that is not shown.
float radiusOf(vec4 position, vec4 velocity) {
  precise float radius = instanceSize(position.w) * shapeRadius_;
  return isShown(position, velocity) && isNumber(radius) ? max(radius, 0.0f) : 0.0f;
}
