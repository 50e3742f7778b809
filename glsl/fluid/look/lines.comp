// Draws the streamlines of a fluid: colour in rgb, brightness of the line in a. The output has `size` * lineDetail
// pixels and no ring. One invocation per pixel.
#include "common/hash.glsl"
#include "fluid/grid.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
STATE_ARRAY(nextFlowBinding, NextBlock, shown)
INPUT_ARRAY(carriedBinding, StopBlock, stops)  // Colour stops of the colour map
uniform int lineDetail;
uniform float linePerDetail, linePhase;
uniform vec3 obstacleColor;
#include "common/color_map.glsl"
#include "fluid/look/lines.glsl"

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= size.x * lineDetail || y >= size.y * lineDetail) return;
  precise float px = (float(x) + 0.5) * linePerDetail;
  precise float py = (float(y) + 0.5) * linePerDetail;
  vec2 p = vec2(px, py);
  vec4 color = vec4(obstacleColor, 0.0);
  float line = 0.0;
  if (!isSolid(x / lineDetail, y / lineDetail)) {
    line = lineAt(p);
    color = lineColor(mappedColor(speedAt(p)), line);
  }
  STORE_STATE(shown, y * size.x * lineDetail + x, vec4(color.xyz, line));
}
