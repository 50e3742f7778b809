// Keeps lines apart. Each line claims the cells in which its points are; a cell is half a separation wide. Lines have
// ranks in a fixed random order. A line ends before its first point next to a cell that a line of lower rank has
// claimed. If that is so for its seed, the line has no points. The claims of a line depend only on the lines of lower
// rank, so rounds of claiming and trimming give the same lines as placing them one after another.
#include "streamlines/lines.glsl"
uniform int round;         // number of rounds that follow
uniform ivec2 cellCount;   // number of columns and rows of cells
uniform vec4 toColumn;     // matrix row that maps a point (x, y, z, 1), in metres, to its column, counted from the left
                           // side of the flow's rectangle
uniform vec4 toRow;        // matrix row that maps a point to its row, counted from the top
layout(std430, binding = 2) buffer ClaimBlock { uint claims[]; };  // minimum of all claims on a cell; a claim consists
                                                                   // of the number of rounds that follow (upper bits)
                                                                   // and the rank

const int rankBits = 20;
uint massWeightOf(int line) {
  uint rank = (uint(line) * 0x9e3b1u) & 0xfffffu;  // The factor is odd, so no two lines have the same rank.
  return (uint(round) << rankBits) | rank;
}

ivec2 cellOf(vec3 p) {
  vec4 place = vec4(p, 1.0);
  int x = int(floor(exactDot(toColumn, place))), y = int(floor(exactDot(toRow, place)));
  return clamp(ivec2(x, y), ivec2(0), cellCount - 1);
}
