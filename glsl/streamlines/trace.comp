// Traces lines through a flow in both directions from seeds on a jittered grid. One invocation per line. The steps have
// equal lengths along the direction of the flow and are computed by the classical fourth-order Runge-Kutta method. A
// line ends at the border, where the flow is still, and after half a turn on each side, so that a closed line is drawn
// only once.
#define WIND
#include "streamlines/lines.glsl"
#include "fluid/wind_array.glsl"
#include "common/hash.glsl"
uniform int columns;
uniform int seed;
uniform vec3 first;     // centre of the top left cell of the grid of seeds, m
uniform vec3 across;    // vector to the next cell on the right, m
uniform vec3 down;      // vector to the next cell below, m
uniform vec3 normal;    // unit normal of the flow's plane
uniform float height;   // distance of the lines from the plane, m
uniform float stride;   // length of a step, m
uniform float still;    // speed below which a line ends, m/s
uniform float low;      // speed of the first colour, m/s
uniform float perRange; // 1 / (speed of the last colour - speed of the first colour), s/m

bool ended = false;  // true once the line has left the flow or met still air

// Returns the direction of the flow at p. Outside of the flow, sets `ended`.
vec3 directionAt(vec3 p) {
  vec3 v = windAt(p);
  float squared = exactDot(v, v);
  precise float minimum = still * still;
  if (squared <= minimum) ended = true;
  precise vec3 unit = v * exactInverseSqrt(max(squared, 1e-30));
  return unit;
}

void store(int line, int i, vec3 p) {
  vec3 v = windAt(p);
  precise vec3 raised = p + normal * height;
  precise float fraction = (exactSqrt(exactDot(v, v)) - low) * perRange;
  STORE_STATE(points, line * perLine + i, vec4(raised, clamp(fraction, 0.0, 1.0)));
}

// Stores the points on one side of the seed and returns their number.
int trace(int line, vec3 from, float sign_) {
  ended = false;
  vec3 p = from;
  vec3 here = directionAt(p);
  precise float h = stride * sign_;
  precise float half_ = 0.5 * h;
  precise float sixth = h * 0.16666667;
  float turned = 0.0;
  int i = 0;
  while (i < aside && !ended) {
    precise vec3 second = p + here * half_;
    vec3 k2 = directionAt(second);
    precise vec3 third = p + k2 * half_;
    vec3 k3 = directionAt(third);
    precise vec3 fourth = p + k3 * h;
    vec3 k4 = directionAt(fourth);
    precise vec3 next = p + (here + 2.0 * (k2 + k3) + k4) * sixth;
    vec3 ahead = directionAt(next);
    if (ended) break;
    ++i;
    store(line, aside + (sign_ > 0.0 ? i : -i), next);
    // The angle between the two directions is 2 asin(c / 2) for the distance c of the unit vectors, which is nearly c
    // (1 + c^2 / 24).
    precise vec3 change = ahead - here;
    float chord = exactSqrt(exactDot(change, change));
    precise float angle = chord * (1.0 + chord * chord * 0.041666667);
    precise float more = exactDot(exactCross(here, ahead), normal) < 0.0 ? turned - angle : turned + angle;
    turned = more;
    if (abs(turned) > 3.1415927) break;
    p = next;
    here = ahead;
  }
  return i;
}

void main() {
  int line = int(gl_GlobalInvocationID.x);
  if (line >= count) return;
  vec3 random = signedUnits(hash3(uvec3(uint(line), uint(seed), 0x51u)));
  precise float column = float(line % columns) + 0.4 * random.x;
  precise float row = float(line / columns) + 0.4 * random.y;
  precise vec3 from = first + (across * column + down * row);
  store(line, aside, from);
  int after = trace(line, from, 1.0), before = trace(line, from, -1.0);
  ivec2 span = ivec2(aside - before, aside + after);
  spans[line] = ivec4(span, span);
}
