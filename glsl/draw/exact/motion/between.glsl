// Interpolates linearly between two frames. `part` is 0 at the previous frame and 1 at the current frame.
#include "common/exact.glsl"
uniform float part;

vec3 between(vec3 before, vec3 now) {
  precise vec3 way = now - before;
  precise vec3 place = before + part * way;
  return place;
}
