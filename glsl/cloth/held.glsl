// Interpolates a pinned particle that follows a skinned body between its positions at the frame's begin and end.
// `before` and `now` are the two weights. Compiles as GLSL and as C++.
FUNCTION vec3 heldBetween(vec3 begin, vec3 end, float before, float now) {
  precise vec3 place = begin * before + end * now;
  return place;
}
