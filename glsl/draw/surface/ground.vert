// Draws the ground, a square around the camera's target. SHADOWED: draws the rectangle that shadows can reach.
// Otherwise: draws the four strips around that rectangle, which need no shadow map lookup.
#include "draw/frame_block.glsl"
#include "draw/passed_frame.glsl"
#ifdef SHADOW
#include "draw/surface/light_map.glsl"
#endif
out vec3 worldPosition;
#ifdef SHADOWED
out vec3 place;
#endif

// Returns corner 0 to 3 of a rectangle (low, high), counter-clockwise as seen from above (x right, z down).
vec2 rectangleCorner(vec4 rectangle, int corner) {
  return vec2(corner == 0 || corner == 3 ? rectangle.x : rectangle.z, corner < 2 ? rectangle.w : rectangle.y);
}

void main() {
  passFrame();
  float reach = frame.groundReach;
  vec4 square = frame.target.xzxz + vec4(-reach, -reach, reach, reach);
  vec4 inner = frame.target.xzxz;
#ifdef SHADOW
  inner = clamp(texelFetch(light, 4), square.xyxy, square.zwzw);
#endif
  // Two triangles (0 1 2, 2 3 0): of the rectangle, or of strip k between the inner and outer corners k and k + 1.
  int corner = gl_VertexID % 6;
  corner = corner < 3 ? corner : corner == 5 ? 0 : corner - 1;
#ifdef SHADOWED
  vec2 p = rectangleCorner(inner, corner);
#else
  int strip = gl_VertexID / 6;
  int which = (strip + (corner == 1 || corner == 2 ? 1 : 0)) % 4;
  vec2 p = rectangleCorner(corner < 2 ? square : inner, which);
#endif
  worldPosition = vec3(p.x, frame.groundHeight, p.y);
#ifdef SHADOWED
  place = shadowPlace(worldPosition);
#endif
  gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
