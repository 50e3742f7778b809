// Returns the uv of a surface's shading point and its changes per pixel. GRID: computes the uv from the vertex indices.
#include "draw/exact/surface/vertex_uv.glsl"

Seen seenByUv(Spot spot, vec2 repeats) {
  vec2 a = uvOf(spot.corners.x), b = uvOf(spot.corners.y), c = uvOf(spot.corners.z);
  vec3 w = spot.weight, right = weightsBeside(spot, vec2(1, 0)), above = weightsBeside(spot, vec2(0, -1));
  precise vec2 at = (w.x * a + w.y * b + w.z * c) * repeats;
  precise vec2 across = (right.x * a + right.y * b + right.z * c) * repeats - at;
  precise vec2 up = (above.x * a + above.y * b + above.z * c) * repeats - at;
  Seen seen;
  seen.at = at;
  seen.across = across;
  seen.up = up;
  return seen;
}
