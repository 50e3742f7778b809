// Keeps lines apart. Each line claims the cells in which its points are; a cell is half a separation wide. Lines have
// ranks in a fixed random order. A line ends before the first point that has a cell of a line of lower rank around it,
// and it has no points if its seed has one. The claims of a line depend on the lines of lower rank alone, so rounds of
// claiming and trimming reach the same lines as placing one after the other.
#include "streamlines/lines.glsl"
uniform int round;         // rounds that follow
uniform ivec2 cellCount;   // columns and rows of cells
uniform vec4 toColumn;     // maps a point (m, 1) to its column, from the left side of the flow's rectangle
uniform vec4 toRow;        // maps a point to its row, from the top
layout(std430, binding = 2) buffer ClaimBlock { uint claims[]; };  // least claim: rounds that follow, then rank

const int rankBits = 20;
uint claimOf(int line) {
  uint rank = (uint(line) * 0x9e3b1u) & 0xfffffu;  // an odd factor: no two lines have the same rank
  return (uint(round) << rankBits) | rank;
}

ivec2 cellOf(vec3 p) {
  vec4 place = vec4(p, 1.0);
  int x = int(floor(exactDot(toColumn, place))), y = int(floor(exactDot(toRow, place)));
  return clamp(ivec2(x, y), ivec2(0), cellCount - 1);
}
