// Arrow that shows a velocity v: an instance of a mesh of length 1 along z, whose middle is the origin. The length of
// the arrow is |v| times `scale`, at most `longest`. Arrows shorter than 1/50 of `longest` are left out, because they
// would only be dots.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
STATE_ARRAY(0, PlaceBlock, places)  // xyz: middle of the arrow, m; w: length, m
STATE_ARRAY(1, SpeedBlock, speeds)  // xyz: velocity at which the arrow moves, m/s; w: position in the colour map, 0 to
                                    // 1, or -1 for no arrow
STATE_ARRAY(2, TurnBlock, turns)    // xyz: unit vector along the arrow
uniform int count;
uniform float scale;     // s
uniform float longest;   // m
uniform float low;       // speed of the first colour, m/s
uniform float perRange;  // 1 / (speed of the last colour - low), s/m
uniform float ahead;     // Distance from the point to the arrow's middle, as a fraction of the arrow's length

// Stores arrow `i`, which shows the velocity v at `place`. `motion` is the velocity at which the arrow moves. If
// `drawn` is false, stores no arrow.
void storeArrow(int i, vec3 place, vec3 v, vec3 motion, bool drawn) {
  float squared = exactDot(v, v);
  float speed = exactSqrt(squared);
  precise float reach = speed * scale;
  float long_ = min(reach, longest);
  precise float minimum = 0.02 * longest;
  precise vec3 direction = v * exactInverseSqrt(max(squared, 1e-30));
  precise vec3 middle = place + direction * (ahead * long_);
  precise float fraction = (speed - low) * perRange;
  bool seen = drawn && long_ >= minimum && isNumber(speed);
  STORE_STATE(places, i, vec4(seen ? middle : place, seen ? long_ : 0.0));
  STORE_STATE(speeds, i, vec4(motion, seen ? clamp(fraction, 0.0, 1.0) : -1.0));
  STORE_STATE(turns, i, vec4(seen ? direction : vec3(0.0, 0.0, 1.0), 0.0));
}
