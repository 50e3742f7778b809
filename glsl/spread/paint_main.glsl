void main() {
  ivec2 at;
  if (!strokeCell(gl_GlobalInvocationID.xy, at)) return;
  int i = at.y * ((size.x + 15) >> 4) + at.x;
  uvec4 state = LOAD_WORDS(cells, i);
  uvec4 result = state;
  int value = strokeNumber(stroke);
  uvec4 more = uvec4(0u);  // Change of each count; as an unsigned number, a decrease wraps around.
  for (int k = 0; k < 16; ++k) {
    ivec2 cell = ivec2(16 * at.x + k, at.y);
    if (cell.x >= size.x || !strokePaints(cell)) continue;
    uint place = uint(8 * (k & 3));
    uint before = state[k >> 2] >> place & 255u;
    uint after = painted(before, value, cell);
    result[k >> 2] ^= (before ^ after) << place;
    more[(before >> 6u) + 3u & 3u] -= 1u;
    more[(after >> 6u) + 3u & 3u] += 1u;
  }
  if (result == state) return;
  STORE_WORDS(cells, i, result);
  for (int c = 0; c < 4; ++c)
    if (more[c] != 0u) atomicAdd(counts[4 * countPlace + c], more[c]);
}
