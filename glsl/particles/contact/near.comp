// Lists up to balls.listed neighbours of each ball, which are the first balls near enough to touch it in the substep,
// in the order of the cells around it. The search ends when the list is full, so that crowded cells take little time.
// A list that is not full ends with the ball's own index. One invocation per ball.
#include "particles/contact/kernel.glsl"
INPUT_ARRAY(guessesBinding, GuessBlock, guesses)
INPUT_ARRAY(beginsBinding, BeginBlock, begins)
INPUT_WORDS(tableBinding, TableBlock, table)
STATE_ARRAY(placesBinding, PlaceBlock, places)
STATE_WORDS(listsBinding, ListBlock, lists)
uniform int stamp;  // Serial number of this search

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  vec4 here = LOAD_INPUT(guesses, s);
  float radius = LOAD_INPUT(begins, s).w;
  uvec4 four = uvec4(uint(s));
  int found = 0, touching = 0;
  ivec3 middle = ballCell(here.xyz);
  for (int around = 0; around < 27 && radius > 0.0f && found < stepData.balls.listed; ++around) {
    ivec3 cell = middle + ballNextCell(around);
    uvec4 run = LOAD_INPUT_WORDS(table, int(ballBucket(cell)));
    if (int(run.z) != stamp) continue;
    for (int j = int(run.x); j < int(run.y) && found < stepData.balls.listed; ++j) {
      vec4 other = LOAD_INPUT(guesses, j);
      if (j == s || ballCell(other.xyz) != cell) continue;
      precise float reach = radius + LOAD_INPUT(begins, j).w;
      int near = ballsNear(here.xyz, other.xyz, reach);
      if (near == 0) continue;
      touching += near - 1;
      four = withWord(four, found & 3, uint(j));
      ++found;
      if ((found & 3) != 0) continue;
      STORE_WORDS(lists, ((found >> 2) - 1) * stepData.count + s, four);
      four = uvec4(uint(s));
    }
  }
  if (found < stepData.balls.listed) STORE_WORDS(lists, (found >> 2) * stepData.count + s, four);
  precise float share = ballShare(touching) * exactReciprocal(max(here.w, 1e-30f));
  STORE_STATE(places, s, vec4(here.xyz, share));
}
