void main() {
  ivec2 at;
  if (!strokeCell(gl_GlobalInvocationID.xy, at)) return;
  int i = at.y * ((size.x + 15) >> 4) + at.x;
  uvec4 state = LOAD_WORDS(cells, i);
  uvec4 result = state;
  int value = int(strokeShape.z + 0.5);
  for (int k = 0; k < 16; ++k) {
    ivec2 cell = ivec2(16 * at.x + k, at.y);
    if (cell.x >= size.x || !strokePaints(cell)) continue;
    uint place = uint(8 * (k & 3));
    uint before = state[k >> 2] >> place & 255u;
    result[k >> 2] ^= (before ^ painted(before, value, cell)) << place;
  }
  if (result != state) STORE_WORDS(cells, i, result);
}
