// Copies the results of project.comp (for the ring and the tiles that are not open) into the flow.
#define FLOW_IN_PLACE
#include "fluid/grid.glsl"
#include "fluid/cells.glsl"
#include "fluid/settling.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  ivec2 c = cellHere(0);
  if (c.x > size.x || c.y > size.y) return;
  int i = elementOf(c.x, c.y), plane = planeSize();
  flow[i] = settling[i];
  flow[plane + i] = settling[plane + i];
  flow[3 * plane + i] = settling[2 * plane + i];
  if (settlesHeat) flow[2 * plane + i] = settlingHeat[heatStart + i];
}
