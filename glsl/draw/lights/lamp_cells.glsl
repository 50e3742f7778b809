// Finds the lamps that may light a point. Each cell of a grid has one bit for each of the last RANGED_LAMPS lamps. The
// bit is set if the cell is within the lamp's range (src/draw/lights/lamp_cells.cpp).
#include "draw/arithmetic.glsl"
#include "draw/bindings.glsl"
#include "draw/lights/types.glsl"
layout(binding = lampCellUnit) uniform usamplerBuffer lampCells;

vec3 lampCellVector(int first) {
  return vec3(uintBitsToFloat(texelFetch(lampCells, first).x), uintBitsToFloat(texelFetch(lampCells, first + 1).x),
              uintBitsToFloat(texelFetch(lampCells, first + 2).x));
}
// Returns the index of the first word of the cell that contains p, or -1 outside the grid, where all lamps with a range
// are out of range.
int lampCellAt(vec3 p) {
  ROUNDED vec3 place = (p - lampCellVector(0)) * lampCellVector(3);
  ivec3 at = ivec3(floor(clamp(place, -1.0f, 64.0f)));
  ivec3 count = ivec3(lampCellsAcross, lampCellsUp, lampCellsAcross);
  if (any(lessThan(at, ivec3(0))) || any(greaterThanEqual(at, count))) return -1;
  return lampCellHead + ((at.y * count.z + at.z) * count.x + at.x) * ((RANGED_LAMPS + 31) / 32);
}
