// Computes the arrows at the points of a regular grid in the plane of a flow. One invocation per arrow.
#define WIND
#include "arrows/arrow.glsl"
#include "fluid/wind_array.glsl"
uniform int columns;
uniform vec3 first;   // Position of the top left grid point in the plane, m
uniform vec3 across;  // Vector from a grid point to its right neighbour, m
uniform vec3 down;    // Vector from a grid point to the neighbour below, m
uniform vec3 above;   // Vector from the plane to the arrows, m

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  float column = float(i % columns), row = float(i / columns);
  precise vec3 here = first + (across * column + down * row);
  vec3 v = windAt(here);
  precise vec3 raised = here + above;
  storeArrow(i, raised, v, vec3(0.0), true);
}
