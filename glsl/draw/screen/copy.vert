// Places instanced copies of a mesh or sphere. ADDITIVE: the colour is multiplied by the brightness of the copy.
// SHADOW: also computes the position in the sun's shadow map. LAMPS: also computes the point of the true round surface.
#include "draw/frame_block.glsl"
#include "draw/instances/instance_pull.glsl"
#include "draw/screen/copy_vertex.glsl"
#include "draw/surface/light_map.glsl"
uniform float swell;  // distance of the facets of a round shape from the true surface, as a fraction of the shape's
                      // size
flat out vec3 tint;
out vec3 worldNormal;
out vec3 worldPosition;
out vec3 place;
#ifdef LAMPS
out vec3 onRound;  // point of the true round surface that the facet approximates
#endif

void main() {
  vec4 position, velocity;
  gl_Position = nowhere;
  tint = worldNormal = worldPosition = place = vec3(0);
#ifdef LAMPS
  onRound = vec3(0);
#endif
  if (!pulled(position, velocity)) return;
  mat3 axes = turned(listedSlot, velocity.xyz);
  worldPosition = position.xyz + axes * (instanceSize(position.w) * texelFetch(shape, vertexOfShape() * 2).xyz);
  worldNormal = axes * texelFetch(shape, vertexOfShape() * 2 + 1).xyz;
  tint = tintOf(position, velocity);
#ifdef ADDITIVE
  tint *= brightnessAt(velocity.w);
#endif
#ifdef LAMPS
  onRound = worldPosition + (swell * shapeRadius * instanceSize(position.w)) * worldNormal;
#elif defined SHADOW
  vec3 onRound = worldPosition + (swell * shapeRadius * instanceSize(position.w)) * worldNormal;
#endif
#ifdef SHADOW
  place = shadowPlace(onRound + shadowLift(worldNormal));
#endif
  gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
