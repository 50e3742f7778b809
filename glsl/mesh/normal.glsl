// Normal of a vertex from the adjacent faces. Compiles as GLSL and as C++ (src/sim/mesh/deform_cpu.cpp). The including
// file provides loadDisplaced(int), loadFan(int) -> uvec4 and loadFaces(int) -> uvec4.

FUNCTION vec3 faceNormal(vec3 here, uint b, uint c) {
  precise vec3 left = loadDisplaced(int(b)) - here;
  precise vec3 right = loadDisplaced(int(c)) - here;
  return exactCross(left, right);
}

// Returns the vertex normal: the sum of (b - a) x (c - a) over the faces (a, b, c) around the vertex a, weighted by
// area and added in the order of the faces. An element holds two faces; an unused face is (a, a, a) and adds nothing.
// If all faces are degenerate, returns the rest normal.
FUNCTION vec3 gatheredNormal(int vertex, vec3 atRest) {
  uvec4 fan = loadFan(vertex);
  vec3 here = loadDisplaced(vertex);
  precise vec3 sum = vec3(0.0f);
  for (uint i = 0u; i < fan.y; ++i) {
    uvec4 faces = loadFaces(int(fan.x + i));
    sum = sum + faceNormal(here, faces.x, faces.y) + faceNormal(here, faces.z, faces.w);
  }
  float squared = exactDot(sum, sum);
  precise vec3 unit = sum * exactInverseSqrt(max(squared, 1e-30f));
  return squared < 1e-30f ? atRest : unit;
}
