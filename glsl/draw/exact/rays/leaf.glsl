// From which and to before which of `count` sorted ones leaf i of `leaves` holds: as many as others, or one more. Compiles as GLSL and as C++.
FUNCTION ivec2 heldBy(int i, int count, int leaves) {
  int each = count / leaves, more = count - each * leaves;
  int first = i * each + min(i, more);
  return ivec2(first, first + each + (i < more ? 1 : 0));
}
