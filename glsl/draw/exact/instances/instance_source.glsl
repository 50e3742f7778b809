// Instances by number.
#include "draw/instances/instance.glsl"
uniform int capacity;
uniform uint firstId;  // of the first one's number

// Of a ball around it (m); 0 for one that is not shown.
float radiusOf(vec4 position, vec4 velocity) {
  precise float radius = instanceSize(position.w) * shapeRadius;
  return isShown(position, velocity) && isNumber(radius) ? max(radius, 0.0f) : 0.0f;
}
