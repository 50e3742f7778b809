// Code that the kernels that rasterize the triangles of surfaces have in common. JOINED: triangles of
// draw::JoinedSurfaces; seeSides() first reads whether both sides of a triangle are visible. Defines: as for
// raster_triangle.glsl.
#include "draw/exact/triangles/surface_triangle.glsl"
#include "draw/exact/triangles/raster_triangle.glsl"
uniform uint firstId;
#ifdef JOINED
#include "draw/exact/triangles/owners.glsl"
void seeSides(int number) {
  doubleSided = showsBothSides(uint(number));
}
#else
void seeSides(int number) {}
#endif

Corner cornerOfVertex(uvec4 vertex) {
#ifdef SUN_MAP
  Corner corner = cornerOf(drawnPlace(vertex), 0.0f);
  corner.near = intBitsToFloat(int(vertex.w));
  return corner;
#else
  return cornerOf(drawnPlace(vertex), view.near);
#endif
}
