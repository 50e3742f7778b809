// Vertex positions for drawing into the shadow maps of all lamps at once. Cell number `cell` is face cell % 6 of lamp
// cell / 6. Clip distances cut off geometry beyond the border of a map.
#include "draw/lights/faces.glsl"
#include "draw/lights/lamp_list.glsl"
out float gl_ClipDistance[4];

vec4 nowhereOnFaces() {
  for (int side = 0; side < 4; ++side) gl_ClipDistance[side] = -1.0;
  return vec4(0, 0, 2, 1);
}

vec4 clipOnFace(int cell, vec3 p) {
  int lamp = cell / lampFaces, face = cell % lampFaces;
  vec4 maps = lampMaps(lamp);
  vec3 q = onFace(face, p - lampPlace(lamp).xyz);
  vec2 across = maps.w * q.yz;
  gl_ClipDistance[0] = q.x - across.x;
  gl_ClipDistance[1] = q.x + across.x;
  gl_ClipDistance[2] = q.x - across.y;
  gl_ClipDistance[3] = q.x + across.y;
  vec2 middle = maps.xy * vec2(float(face) + 0.5, 0.5) + vec2(0, maps.z);
  return vec4((2.0 * middle - 1.0) * q.x + maps.xy * across, q.x - 2.0 * lampSampling(lamp).x, q.x);
}
