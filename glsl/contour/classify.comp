// Computes the class of each sample: the number of levels at or below its value. One invocation per sixteen samples.
#include "common/words.glsl"
#include "contour/samples.glsl"
#include "grid/field.glsl"
layout(local_size_x = 64) in;
STATE_WORDS(classesBinding, ClassBlock, classes)
uniform float levels[LEVELS];  // Values of the levels in ascending order

uint classAt(int x, int y) {
  if (x < 1 || y < 1 || x > fieldSize.x || y > fieldSize.y) return uint(outside);
  float value = valueAt(ivec2(x, y) - 1);
  uint reached = 0u;
#define TIMES LEVELS
#define REPEATED(i) reached += value >= levels[i] ? 1u : 0u;
#include "common/repeat.glsl"
  return reached;
}

uint fourAt(int x, int y) {
  return classAt(x, y) | classAt(x + 1, y) << 8u | classAt(x + 2, y) << 16u | classAt(x + 3, y) << 24u;
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= elementCount()) return;
  int y = i / rowElements, x = 16 * (i - y * rowElements);
  STORE_WORDS(classes, i, uvec4(fourAt(x, y), fourAt(x + 4, y), fourAt(x + 8, y), fourAt(x + 12, y)));
}
