// On the straight way from one frame to the next. `part`: 0 at the one before, 1 at this one.
#include "common/exact.glsl"
uniform float part;

vec3 between(vec3 before, vec3 now) {
  precise vec3 way = now - before;
  precise vec3 place = before + part * way;
  return place;
}
