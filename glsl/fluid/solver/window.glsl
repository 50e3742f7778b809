// Window of a level: the cells of several blocks in the shared array `values`, with a border of one cell. The including
// file declares `values` and `windowStride`, the number of values per row.
int cornerOf(ivec2 place) {
  return (2 * place.y + 1) * windowStride + 2 * place.x + 1;
}

void putReds(int at, vec4 here) {
  values[at] = here.x;
  values[at + windowStride + 1] = here.w;
}

void putBlacks(int at, vec4 here) {
  values[at + 1] = here.y;
  values[at + windowStride] = here.z;
}

// Returns the neighbours outside the block for sweepReds() and leftInReds().
vec4 besideReds(int at) {
  return vec4(values[at - 1], values[at - windowStride], values[at + windowStride + 2], values[at + 2 * windowStride + 1]);
}

// Returns the neighbours outside the block for sweepBlacks().
vec4 besideBlacks(int at) {
  return vec4(values[at + 2], values[at + 1 - windowStride], values[at + windowStride - 1], values[at + 2 * windowStride]);
}
