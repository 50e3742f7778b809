// One arrow of a velocity: an instance of a mesh of length 1 along z, whose middle is the origin. Its length is |v|
// times `scale`, at most `longest`; arrows shorter than a fiftieth of that are left out, because they are no more than
// dots.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(0, PlaceBlock, places)  // x, y, z: middle, m; w: length, m
STATE_ARRAY(1, SpeedBlock, speeds)  // x, y, z: velocity of the arrow itself, m/s; w: colour, 0 to 1; -1: no arrow
STATE_ARRAY(2, TurnBlock, turns)    // x, y, z: unit vector along the arrow
uniform int count;
uniform float scale;     // s
uniform float longest;   // m
uniform float low;       // speed of the first colour, m/s
uniform float perRange;  // 1 / (speed of the last colour - low), s/m
uniform float ahead;     // distance from the place to the arrow's middle, in lengths of the arrow

// Stores arrow `i` of the velocity v at `place`. `motion`: velocity of the place. `drawn`: false for none.
void storeArrow(int i, vec3 place, vec3 v, vec3 motion, bool drawn) {
  float squared = exactDot(v, v);
  float speed = exactSqrt(squared);
  precise float reach = speed * scale;
  float long_ = min(reach, longest);
  precise float least = 0.02 * longest;
  precise vec3 direction = v * exactInverseSqrt(max(squared, 1e-30));
  precise vec3 middle = place + direction * (ahead * long_);
  precise float fraction = (speed - low) * perRange;
  bool seen = drawn && long_ >= least && isNumber(speed);
  STORE_STATE(places, i, vec4(seen ? middle : place, seen ? long_ : 0.0));
  STORE_STATE(speeds, i, vec4(motion, seen ? clamp(fraction, 0.0, 1.0) : -1.0));
  STORE_STATE(turns, i, vec4(seen ? direction : vec3(0.0, 0.0, 1.0), 0.0));
}
