// A pinned particle that follows a skin: on the way from the frame's beginning to its end. Compiles as GLSL and as C++.
FUNCTION vec3 heldBetween(vec3 begin, vec3 end, float before, float now) {
  precise vec3 place = begin * before + end * now;
  return place;
}
