// Returns the first item and the end (exclusive) of leaf i. The `count` sorted items are distributed evenly over
// `leaves` leaves. Compiles as GLSL and as C++.
FUNCTION ivec2 heldBy(int i, int count, int leaves) {
  int each = count / leaves, more = count - each * leaves;
  int first = i * each + min(i, more);
  return ivec2(first, first + each + (i < more ? 1 : 0));
}
