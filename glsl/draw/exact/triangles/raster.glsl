// What the kernels that find the visible triangles of surfaces have in common. Variants of raster_triangle.glsl.
#include "draw/exact/triangles/surface_triangle.glsl"
#include "draw/exact/triangles/raster_triangle.glsl"
uniform uint firstId;

Corner cornerOfVertex(uvec4 vertex) {
#ifdef SUN_MAP
  Corner corner = cornerOf(placeOf(vertex), 0.0f);
  corner.near = intBitsToFloat(int(vertex.w));
  return corner;
#else
  return cornerOf(placeOf(vertex), view.near);
#endif
}
