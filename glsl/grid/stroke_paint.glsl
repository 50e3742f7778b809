// What a paint kernel asks of the stroke it is run for: one dispatch over the stroke's box. Bindings are the
// kernel's own: declare `strokeBits` with INPUT_WORDS before including this.
#include "common/hash.glsl"
#include "grid/stroke.glsl"
uniform vec4 strokeSegment;
uniform vec4 strokeShape;
uniform ivec4 strokeImage;
uniform ivec4 strokeRandom;
uniform ivec4 strokeBox;  // first column and row, and how many of each

Stroke currentStroke() {
  return Stroke(strokeSegment, strokeShape, strokeImage, strokeRandom);
}

// The cell of this invocation; outside the box: false.
bool strokeCell(uvec2 invocation, out ivec2 cell) {
  cell = strokeBox.xy + ivec2(invocation);
  return all(lessThan(ivec2(invocation), strokeBox.zw));
}

bool strokePaints(ivec2 cell) {
  Stroke s = currentStroke();
  if (!strokePicks(s, cell)) return false;
  if (s.image.w == 0) return strokeReaches(s, cell);
  ivec2 at = cell - s.image.xy;
  if (any(lessThan(at, ivec2(0))) || at.x >= s.image.w || at.y >= s.random.z) return false;
  int bit = at.y * s.image.w + at.x;
  int word = s.image.z + (bit >> 5);
  uvec4 words = LOAD_INPUT_WORDS(strokeBits, word >> 2);
  return (words[word & 3] >> uint(bit & 31) & 1u) != 0u;
}
