// Ends each line before cells that lines of lower rank have claimed in this round. In the last round, lines only become
// shorter, and short lines are left out. One invocation per line.
#include "streamlines/claims.glsl"
uniform int fewest;  // minimum number of points between the ends of a line

bool isFree(int line, int i, uint claim) {
  ivec2 cell = cellOf(LOAD_STATE(points, line * perLine + i).xyz);
  for (int y = max(cell.y - 1, 0); y <= min(cell.y + 1, cellCount.y - 1); ++y)
    for (int x = max(cell.x - 1, 0); x <= min(cell.x + 1, cellCount.x - 1); ++x)
      if (claims[y * cellCount.x + x] < claim) return false;
  return true;
}

void main() {
  int line = int(gl_GlobalInvocationID.x);
  if (line >= count) return;
  ivec4 span = spans[line];
  ivec2 maximum = round == 0 ? span.xy : span.zw;
  uint claim = massWeightOf(line);
  bool none = maximum.x > maximum.y || maximum.x > aside || maximum.y < aside || !isFree(line, aside, claim);
  int begin = aside, end = aside;
  while (!none && end < maximum.y && isFree(line, end + 1, claim)) ++end;
  while (!none && begin > maximum.x && isFree(line, begin - 1, claim)) --begin;
  if (round == 0 && end - begin < fewest) none = true;
  spans[line] = ivec4(none ? ivec2(aside, aside - 1) : ivec2(begin, end), span.zw);
}
