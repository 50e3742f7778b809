// Where the vertices of a solid are. Compiles as GLSL and as C++. Needs common/exact.glsl.
#ifndef CONTACT_PLACE
#define CONTACT_PLACE

// Three rows of a matrix.
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
// On a straight line, at the share `now` of its way; who stays stays to the bit.
FUNCTION vec3 onTheWay(vec3 begin, vec3 end, float now) {
  precise vec3 place = begin + (end - begin) * now;
  return now == 1.0f ? end : place;
}

#endif
