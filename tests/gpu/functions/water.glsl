WaterStep water;
WaterLook look;
ivec2 size;
int lake;

// Returns a water cell. Cells have stepped beds, shores, dry areas and thin layers of water.
FUNCTION vec4 loadWater(int i) {
  vec3 flows = somePlace(i, lake);
  uvec3 bits = diced(i, lake + 1);
  precise float bed = float(int(bits.x % 4u)) * 0.25f;
  float depth = (bits.y & 7u) == 0u ? 0.0f : (bits.y & 7u) == 1u ? 0.015625f : 0.5f * abs(flows.z);
  precise float level = bed + depth;
  precise vec3 discharge = flows * depth;
  return vec4(level, discharge.x, discharge.y, bed);
}
FUNCTION vec4 loadWaterAt(int x, int y) {
  return loadWater(y * size.x + x);
}

#include "water/step.glsl"
#include "water/look.glsl"

// Tests a cell of a small lake. Each invocation has a different lake.
FUNCTION vec4 asked(int i) {
  lake = 2 * i;
  size = ivec2(5, 3);
  water.ratio = 0.125f;
  water.halfRatio = 0.0625f;
  water.gravity = 10.0f;
  water.rain = i % 5 == 0 ? 0.0009765625f : 0.0f;
  water.kept = 0.875f;
  water.manning = i % 3 == 0 ? 0.001f : 0.0f;
  water.thin = 0.03125f;
  water.dry = 0.0078125f;
  water.share = 2.0f;
  water.courant = 0.5f;
  int sides = i % 7;
  water.west = sides == 0 ? periodicEdge : sides == 1 ? seaEdge : sides == 2 ? openEdge : wallEdge;
  water.east = sides == 0 ? periodicEdge : sides == 3 ? seaEdge : sides == 4 ? openEdge : wallEdge;
  water.north = sides == 5 ? periodicEdge : sides == 6 ? seaEdge : sides == 2 ? openEdge : wallEdge;
  water.south = sides == 5 ? periodicEdge : sides == 1 ? seaEdge : sides == 4 ? openEdge : wallEdge;
  water.sea = 0.5f;
  water.seaWest = 0.0625f;
  water.seaEast = -0.125f;
  water.seaNorth = 0.25f;
  water.seaSouth = 0.1875f;
  look.cell = 0.5f;
  look.base = 0.25f;
  look.shallow = 0.0625f;
  look.thin = 0.03125f;
  look.perClarity = 0.75f;
  look.foam = 0.75f;
  look.calm = 0.125f;
  int x = someOf(i, 3, 5), y = someOf(i, 4, 3);
  if (i % 2 == 0) return waterStepped(x, y);
  vec4 shown = waterShown(x, y);
  WaterDrop drop;
  drop.center = vec2(float(x) + someNumber(diced(i, 5).x), float(y) + someNumber(diced(i, 5).y));
  drop.perRadius2 = 1.5f;
  drop.height = 0.25f;
  drop.shallow = 0.0625f;
  precise vec4 all_ = i % 4 == 1 ? shown : vec4(waterCourant(waterCell(loadWaterAt(x, y), water.thin), water),
                                              waterDropAt(drop, ivec2(x, y), loadWaterAt(x, y)), waterValues(x, y).w, shown.y);
  return all_;
}
