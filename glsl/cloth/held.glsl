// Interpolates the position of a pinned particle that follows a skinned body, between the positions at the start and at
// the end of a frame. `before` and `now` are the weights of these positions. Compiles as GLSL and as C++.
FUNCTION vec3 heldBetween(vec3 begin, vec3 end, float before, float now) {
  precise vec3 place = begin * before + end * now;
  return place;
}
