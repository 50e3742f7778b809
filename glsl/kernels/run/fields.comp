// Fills a user's texture with another object's field (grid/field.glsl), interpolated bilinearly between the centres of
// the field's cells unless the values are categories. A field of the texture's size is copied. Colours give red, green,
// blue and the value; other fields give their value three times, and 1. Each invocation takes every `threads`-th texel. TEXELS is 0 for
// floats, 1 for ints, 2 for uints.
#include "common/exact.glsl"
#include "common/words.glsl"
#include "reaction/sampling.glsl"
layout(local_size_x = 64) in;
const int fieldUnit = 1;
#include "grid/field.glsl"
STATE_WORDS(0, TexelBlock, texels)
uniform ivec2 size;     // size of the texture
uniform int threads;    // number of invocations
uniform bool upward;    // true if the first row of texels is the lowest row of the field
uniform bool separate;  // true if values must not be interpolated between cells

vec4 cellAt(int x, int y) {
#if CELLS == 3
  vec4 cell;
  for (int c = 0; c < 4; ++c) {
    float value = uintBitsToFloat(fieldWord(firstWord + y * rowWords + x * cellWords + c));
    cell[c] = isNumber(value) ? clamp(value, -1e20, 1e20) : 0.0;
  }
  return cell;
#else
  return vec4(vec3(valueAt(ivec2(x, y))), 1.0);
#endif
}

vec4 between(vec4 a, vec4 b, float share) {
  vec4 mixed;
  for (int c = 0; c < 4; ++c) mixed[c] = share == 0.0 ? a[c] : betweenOf(a[c], b[c], share);
  return mixed;
}

void fillTexel(int i) {
  int row = i / size.x;
  Between across = betweenCells(i % size.x, size.x, fieldSize.x);
  Between down = betweenCells(upward ? size.y - 1 - row : row, size.y, fieldSize.y);
  if (separate) {
    across.before = across.share < 0.5 ? across.before : across.after;
    down.before = down.share < 0.5 ? down.before : down.after;
    across.share = 0.0;
    down.share = 0.0;
  }
  vec4 above = between(cellAt(across.before, down.before), cellAt(across.after, down.before), across.share);
  vec4 below = between(cellAt(across.before, down.after), cellAt(across.after, down.after), across.share);
  vec4 texel = between(above, below, down.share);
#if TEXELS == 0
  STORE_WORDS(texels, i, floatBitsToUint(texel));
#elif TEXELS == 1
  STORE_WORDS(texels, i, uvec4(ivec4(clamp(texel, -2147483000.0, 2147483000.0))));
#else
  STORE_WORDS(texels, i, uvec4(clamp(texel, 0.0, 4294967000.0)));
#endif
}

void main() {
  for (int i = int(gl_GlobalInvocationID.x); i < size.x * size.y; i += threads) fillTexel(i);
}
