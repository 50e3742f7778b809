#include "mesh/height_types.glsl"

HeightGrid heightGrid;

FUNCTION vec4 loadHeights(int i) {
  return vec4(somePlace(i, 9), 0.0f);
}

#include "mesh/height_model.glsl"

// Tests positions above the height grid, on its sides and corners, and outside it.
FUNCTION vec4 asked(int i) {
  heightGrid.corner = vec2(-1.0f, -0.5f);
  heightGrid.perCell = vec2(2.0f, 1.0f);
  heightGrid.size = ivec2(5, 3);
  heightGrid.progress = 0.25f;
  heightGrid.perFrame = 24.0f;
  heightGrid.kept = 0.5f;
  heightGrid.bounce = 0.25f;
  heightGrid.margin = 0.125f;
  vec3 place = somePlace(i, 0);
  precise float z = place.z + 0.5f;
  SurfacePoint under = surfaceUnder(place.x, z);
  vec3 speed = somePlace(i, 1);
  Landing there = landed(vec3(place.x, place.y, z), speed);
  return i % 2 == 0 ? vec4(there.position, there.velocity.x) : vec4(there.velocity, under.there ? 1.0f : 0.0f);
}
