// The members of FluidSolidSet that the tested functions need.
struct FewSolids {
  FluidSolid solids[3];
  vec4 growth[1];
};
FewSolids solidSet;
FluidStep stepData;
FluidBrush brushes[2];
ivec2 size;
int firstBrush, endBrush, leftKind, rightKind, topKind, bottomKind;
bool heats, viscous, confines, sinks, secondOrder, cubic, obstacles, obstaclesSlip, obstaclesMove, pocketsGrow;
int tank = 0;

FUNCTION int elementAt(int x, int y) {
  return (y + 1) * 16 + x + 1;
}
FUNCTION vec4 flowAt(int x, int y) {
  return vec4(somePlace(elementAt(x, y), tank), someNumber(diced(elementAt(x, y), tank).y));
}
FUNCTION vec4 carriedAt(int x, int y) {
  return vec4(somePlace(elementAt(x, y), tank + 1), 0.0f);
}
FUNCTION vec4 dyeAt(int x, int y) {
  int column = leftKind == periodicSide ? (x + size.x) % size.x : clamp(x, -1, size.x);
  int row = topKind == periodicSide ? (y + size.y) % size.y : clamp(y, -1, size.y);
  return vec4(abs(somePlace(elementAt(column, row), tank + 2)), 0.0f);
}
FUNCTION vec2 faceAt(int x, int y) {
  ivec2 drawn = ivec2(someOf(elementAt(x, y), tank + 3, 4), someOf(elementAt(x, y), tank + 4, 4));
  return obstacles ? vec2(drawn) * vec2(0.5f, 0.4375f) : vec2(1.0f);
}
FUNCTION uint solidWord(int x, int y) {
  uvec3 bits = diced(elementAt(x, y), tank + 5);
  return obstacles ? (32768u + bits.x % 8192u - 4096u) | ((bits.y % 3u) << 16u) | ((bits.z & 3u) << 24u) : 0xffffu;
}
FUNCTION vec2 sumAt(int x, int y) {
  return vec2(somePlace(elementAt(x, y), tank + 6)) * vec2(1.0f, 0.0001f);
}
FUNCTION bool brushPaints(int i, ivec2 cell) {
  return (diced(8 * cell.y + cell.x, tank + i).z & 1u) != 0u;
}

#include "fluid/transport.glsl"
#include "fluid/projected.glsl"
#include "fluid/brush.glsl"

FUNCTION int someSide(int i, int k) {
  return someOf(i, k, 4);
}

FUNCTION vec4 asked(int i) {
  tank = 16 * i;
  size = ivec2(5, 4);
  bool round_ = i % 7 == 0;
  leftKind = round_ ? periodicSide : someSide(i, 1);
  rightKind = round_ ? periodicSide : someSide(i, 2);
  topKind = i % 11 == 0 ? periodicSide : someSide(i, 3);
  bottomKind = i % 11 == 0 ? periodicSide : someSide(i, 4);
  uvec3 bits = diced(i, 5);
  heats = (bits.x & 1u) != 0u;
  viscous = (bits.x & 2u) != 0u;
  confines = (bits.x & 4u) != 0u;
  sinks = (bits.x & 8u) != 0u;
  secondOrder = (bits.x & 16u) != 0u;
  cubic = !secondOrder && (bits.x & 32u) != 0u;
  obstacles = (bits.x & 64u) != 0u;
  obstaclesSlip = (bits.x & 128u) != 0u;
  obstaclesMove = (bits.x & 256u) != 0u;
  pocketsGrow = (bits.x & 512u) != 0u;
  stepData.leftRight = vec4(0.5f, 0.25f, -0.5f, 0.125f);
  stepData.topBottom = vec4(0.25f, 0.5f, 0.125f, -0.5f);
  stepData.dt = 0.5f;
  stepData.perDt = 2.0f;
  stepData.viscosity = 0.125f;
  stepData.confinement = 0.25f;
  stepData.lift = 0.375f;
  stepData.keptHeat = 0.875f;
  stepData.dyeDt = 0.25f;
  stepData.weight = 0.0625f;
  stepData.parabolas = vec4(1.0f, 0.0f, 1.0f, 0.0f);
  stepData.confined = vec4(0.75f, 0.0f, 0.0f, 0.0f);
  for (int k = 0; k < 3; ++k) {
    solidSet.solids[k].place = vec4(float(k) + 0.5f, 1.5f, 0.25f * float(k - 1), 0.0f);
    solidSet.solids[k].velocity = vec4(0.25f, -0.125f * float(k), 0.0f, 0.0f);
  }
  solidSet.growth[0] = vec4(0.125f, -0.25f, 0.0f, 0.0625f);
  firstBrush = 0;
  endBrush = someOf(i, 6, 3);
  for (int k = 0; k < 2; ++k) {
    brushes[k].segment = vec4(1.0f, 0.5f, k == 0 ? 1.0f : 3.0f, 2.5f);
    brushes[k].reach = vec4(2.25f, k == 0 ? 0.0f : 0.125f, 0.5f, (bits.y & 1u) == 0u ? 0.0f : 0.75f);
    brushes[k].stamp = ivec4(0, 0, 0, int((bits.z >> uint(4 * k)) & 7u));
    brushes[k].flow = vec4(0.5f, -0.25f, 1.0f, 0.0f);
    brushes[k].force = vec4(0.125f, 0.25f, 0.0f, 0.0f);
    brushes[k].dye = vec4(1.0f, 0.5f, 0.25f, 0.0f);
  }
  int x = someOf(i, 8, 7) - 1, y = someOf(i, 9, 6) - 1;
  int what = i % 7;
  if (what == 0) return carriedCell(x, y);
  if (what == 1) return pushedCell(0.5f, x, y);
  if (what == 2) return steppedCell(x, y);
  if (what == 3) return dyedCell(x, y);
  if (what == 4) return i % 2 == 0 ? paintedCell(x, y) : paintedDye(x, y);
  if (what == 5) return finishedCell(x, y);
  int ix = insideX(x), iy = insideY(y);
  return vec4(missingFlow(ix, iy), stillMissing(ix, iy), curlAt(ix, iy), openPart(ix, iy));
}
