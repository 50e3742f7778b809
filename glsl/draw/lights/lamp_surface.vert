// Draws a surface into the lamps' shadow maps: one instance for each map that may show the surface.
#include "draw/frame_block.glsl"
#include "draw/surface/vertex_pull.glsl"
#include "draw/lights/face_clip.glsl"
layout(binding = cellUnit) uniform usamplerBuffer cells;
uniform int firstCell;

void main() {
  gl_Position = clipOnFace(int(texelFetch(cells, firstCell + gl_InstanceID).x), worldPoint(gl_VertexID));
}
