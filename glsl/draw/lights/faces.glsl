// The six shadow maps around a lamp: face 2k looks along axis k, face 2k + 1 against it. `from` is from the lamp (m).
// On a face a place has the distance x along its axis and y, z across it; the map covers |y|, |z| <= x.
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

// Depth grows from 0 at the nearest caster towards 1; planes are planes in it, so the rasteriser's offset by slope holds.
float faceDepth(float along, float nearest) {
  return 1.0 - nearest / along;
}
