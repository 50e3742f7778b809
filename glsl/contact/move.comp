// Computes the vertices of a solid at a time within the frame. The mesh may be moved, deformed or both. One invocation
// per vertex.
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "contact/bindings.glsl"
#include "contact/place.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(beginBinding, BeginBlock, begins)
INPUT_ARRAY(endBinding, EndBlock, ends)
STATE_ARRAY(placesBinding, PlaceBlock, places)
uniform int count;
uniform float now;  // Time within the frame, as a fraction from 0 to 1
uniform Placement begin;
uniform Placement end;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec3 place = onTheWay(placedBy(begin, LOAD_INPUT(begins, i).xyz), placedBy(end, LOAD_INPUT(ends, i).xyz), now);
  STORE_STATE(places, i, vec4(place, 0.0f));
}
