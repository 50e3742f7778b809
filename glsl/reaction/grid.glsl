// Memory layout of the planes of a rule: rows of `columns` elements with four cells each, x fastest. TAIL is the index
// of the last cell in a row's last element. If it is not 3, that is, if the width is not a multiple of four, the unused
// cells are 0 and are ignored. BOUNDARY is the boundary condition: 0 torus, 1 no flux, 2 fixed.
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
uniform ivec2 size;   // Number of cells per axis; a mesh has a single row
uniform int columns;  // Number of elements per row
uniform int stepNumber;
#ifdef VOLUME
uniform int depth;       // Number of layers; a layer has size.y rows, and a plane stores the layers one after another
uniform int planeRows;   // Number of rows in all layers
uniform int layerItems;  // Number of invocations along y per layer
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

// Returns the left neighbours of the four cells `here` of element x. `left` is the element before it.
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

// Returns the value to store for an element, in which cells beyond the end of the row are 0.
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

// Returns the maximum exponent of four cells, as float bits. The five lowest bits identify the cell: 31 - 4 plane -
// cell. If a cell is infinite or NaN, the result is at least lostBits.
const int lostBits = 0x7f800000;
int exponentOf(vec4 cells, int plane) {
  ivec4 bits = (floatBitsToInt(cells) & lostBits) | (ivec4(31, 30, 29, 28) - 4 * plane);
  return max(max(bits.x, bits.y), max(bits.z, bits.w));
}

// Reports a lost cell. `y` is the index of the row in its plane.
void noteCell(int bits, int x, int y) {
  int cellInRow = 31 - (bits & 31);
  noteLost(uint(stepNumber), uint(((cellInRow >> 2) * PLANE_ROWS + y) * size.x + min(4 * x + (cellInRow & 3), size.x - 1)));
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

// Returns the column indices, as floats, of the four cells of element x.
vec4 cellsOf(int x) {
  return vec4(4 * x, 4 * x + 1, 4 * x + 2, 4 * x + 3);
}
vec4 hashed(int x, int y, uint step_, uint salt) {
  uint cell = uint(y * size.x + 4 * x);
  return vec4(signedUnit(hash3(uvec3(cell, step_, salt)).x), signedUnit(hash3(uvec3(cell + 1u, step_, salt)).x),
              signedUnit(hash3(uvec3(cell + 2u, step_, salt)).x), signedUnit(hash3(uvec3(cell + 3u, step_, salt)).x));
}
