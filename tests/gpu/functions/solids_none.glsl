// Provides empty meshes, grounds and walls for functions that need them but are tested without them.
#include "collide/field_types.glsl"
#include "contour/wall_types.glsl"
#include "fluid/wind_types.glsl"
#include "mesh/height_types.glsl"

struct NoMeshes {
  MeshCollider meshes[1];
  int count;
};
NoMeshes meshData;
HeightGrid heightGrid;
WallGrid wallGrid;
WindGrid windGrid;
bool blown;

FUNCTION uvec4 loadFieldCell(int i) {
  return uvec4(uint(i));
}
FUNCTION vec4 loadHeights(int i) {
  return vec4(float(i));
}
FUNCTION int loadWallClass(int x, int y) {
  return x + y;
}
FUNCTION float loadWallValue(int x, int y) {
  return float(x + y);
}
FUNCTION vec4 loadWindCell(int x, int y) {
  return vec4(somePlace(8 * (y + 1) + x + 1, 90), 0.0f);
}

// Sets the wind to the flow of a fluid rectangle of 4 x 3 cells, which is skewed in the world.
FUNCTION void blow(bool blows) {
  meshData.count = 0;
  blown = blows;
  windGrid.across = vec4(2.0f, 0.5f, 0.0f, 2.0f);
  windGrid.down = vec4(0.0f, -2.0f, 0.5f, 1.5f);
  windGrid.alongX = vec3(0.5f, 0.0f, 0.125f);
  windGrid.alongY = vec3(0.0f, -0.5f, 0.125f);
  windGrid.size = ivec2(4, 3);
}

#include "mesh/height_model.glsl"
#include "contour/model.glsl"
#include "contour/wall_model.glsl"
#include "fluid/wind_model.glsl"
