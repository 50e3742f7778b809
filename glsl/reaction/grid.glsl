// How the planes of a rule lie in memory: rows of `columns` elements, four cells each, x fastest. Where the width is no
// multiple of four (TAIL, the last cell in a row's last element, is not 3) what lies behind the last cell is 0 and is not
// looked at. Beyond the edges comes what BOUNDARY says: 0 torus, 1 no flux, 2 fixed.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/once.glsl"
#include "common/status.glsl"
#include "reaction/bindings.glsl"
#include "reaction/functions.glsl"
#ifdef MESH
#include "common/words.glsl"
#endif
uniform ivec2 size;   // cells; of a mesh one row of all
uniform int columns;  // elements of a row
uniform int stepNumber;
#ifdef VOLUME
uniform int depth;       // layers of size.y rows, one after the other in a plane
uniform int planeRows;   // of all layers
uniform int layerItems;  // invocations down a layer
#define PLANE_ROWS planeRows

int layerAt(int z) {
#if BOUNDARY == 0
  return z < 0 ? z + depth : z >= depth ? z - depth : z;
#else
  return clamp(z, 0, depth - 1);
#endif
}
#else
#define PLANE_ROWS size.y
#endif

int rowAt(int y) {
#if BOUNDARY == 0
  return y < 0 ? y + size.y : y >= size.y ? min(y - size.y, size.y - 1) : y;
#else
  return clamp(y, 0, size.y - 1);
#endif
}

int columnAt(int x) {
#if BOUNDARY == 0
  return x < 0 ? columns - 1 : x >= columns ? 0 : x;
#else
  return clamp(x, 0, columns - 1);
#endif
}

// The cells to the left of the four `here` of element x; `left` is the element before them.
vec4 leftOf(vec4 left, vec4 here, int x) {
#if BOUNDARY == 0
  float beside = x == 0 ? left[TAIL] : left.w;
#else
  float beside = x == 0 ? here.x : left.w;
#endif
  return vec4(beside, here.xyz);
}

vec4 rightOf(vec4 here, vec4 right, int x) {
#if BOUNDARY == 0
  float beside = right.x;
#else
  float beside = x == columns - 1 ? here[TAIL] : right.x;
#endif
  vec4 all = vec4(here.yzw, beside);
#if TAIL != 3
  if (x == columns - 1) all[TAIL] = beside;
#endif
  return all;
}

// What is stored of an element.
vec4 kept(vec4 cells, int x) {
#if TAIL == 0
  if (x == columns - 1) cells.yzw = vec3(0);
#elif TAIL == 1
  if (x == columns - 1) cells.zw = vec2(0);
#elif TAIL == 2
  if (x == columns - 1) cells.w = 0.0f;
#endif
  return cells;
}

// The greatest exponent of four cells, as bits, and below it who has it: 31 - 4 plane - cell. Of what is not a number it is
// lostBits or more.
const int lostBits = 0x7f800000;
int exponentOf(vec4 cells, int plane) {
  ivec4 bits = (floatBitsToInt(cells) & lostBits) | (ivec4(31, 30, 29, 28) - 4 * plane);
  return max(max(bits.x, bits.y), max(bits.z, bits.w));
}

// `y`: the row of its plane.
void noteCell(int bits, int x, int y) {
  int who = 31 - (bits & 31);
  noteLost(uint(stepNumber), uint(((who >> 2) * PLANE_ROWS + y) * size.x + min(4 * x + (who & 3), size.x - 1)));
}

vec4 grained(vec4 x, float grain) {
  precise vec4 raised = x + grain;
  precise vec4 rest = raised - grain;
  return rest;
}

#define EACH_CELL(f, a) vec4(f(a.x), f(a.y), f(a.z), f(a.w))
#define EACH_PAIR(f, a, b) vec4(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w))

float rootOf(float x) {
  return exactSqrt(max(x, 0.0f));
}
float logOf(float x) {
  return exactLog(max(x, 1e-30f));
}

// As numbers, four cells from x on.
vec4 cellsOf(int x) {
  return vec4(4 * x, 4 * x + 1, 4 * x + 2, 4 * x + 3);
}
vec4 hashed(int x, int y, uint step_, uint salt) {
  uint cell = uint(y * size.x + 4 * x);
  return vec4(signedUnit(hash3(uvec3(cell, step_, salt)).x), signedUnit(hash3(uvec3(cell + 1u, step_, salt)).x),
              signedUnit(hash3(uvec3(cell + 2u, step_, salt)).x), signedUnit(hash3(uvec3(cell + 3u, step_, salt)).x));
}
