// The six shadow maps around a lamp. Face 2k faces along axis k; face 2k + 1 faces in the opposite direction. `from` is
// the vector from the lamp to a point (m). In the coordinates of a face, x is the distance along the face's axis, and y
// and z are perpendicular to it. The map covers |y| <= x and |z| <= x.
vec3 turnedTo(int axis, vec3 from) {
  return axis == 0 ? from : axis == 1 ? from.yzx : from.zxy;
}

vec3 onFace(int face, vec3 from) {
  vec3 q = turnedTo(face >> 1, from);
  return (face & 1) != 0 ? vec3(-q.x, q.yz) : q;
}

int faceOf(vec3 from) {
  vec3 a = abs(from);
  int axis = a.x >= max(a.y, a.z) ? 0 : a.y >= a.z ? 1 : 2;
  return 2 * axis + int(turnedTo(axis, from).x < 0.0);
}

// Returns the depth of a point in a shadow map: 0 at the nearest caster, growing towards 1. Planes stay planes in this
// depth, so the rasterizer's slope offset works.
float faceDepth(float along, float nearest) {
  return 1.0 - nearest / along;
}
