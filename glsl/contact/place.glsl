// Positions of a solid's vertices. Compiles as GLSL and as C++. Needs common/exact.glsl.
#ifndef CONTACT_PLACE
#define CONTACT_PLACE

// Affine transformation: the first three rows of a 4x4 matrix.
struct Placement {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};
FUNCTION vec3 placedBy(Placement m, vec3 p) {
  precise vec3 place = vec3(m.row0.x, m.row1.x, m.row2.x) * p.x + vec3(m.row0.y, m.row1.y, m.row2.y) * p.y +
                       vec3(m.row0.z, m.row1.z, m.row2.z) * p.z + vec3(m.row0.w, m.row1.w, m.row2.w);
  return vec3(exactFlush(place.x), exactFlush(place.y), exactFlush(place.z));
}
// Interpolates linearly from `begin` to `end` at the fraction `now`. If both are equal, the result equals them exactly.
FUNCTION vec3 onTheWay(vec3 begin, vec3 end, float now) {
  precise vec3 place = begin + (end - begin) * now;
  return now == 1.0f ? end : place;
}

#endif
