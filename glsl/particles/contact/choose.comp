// Chooses for each ball the neighbour with which it collides first in the substep; its own index if there is none. One
// ball per invocation.
#include "particles/contact/kernel.glsl"
#include "collide/friction.glsl"
#include "particles/contact/impact.glsl"
INPUT_ARRAY(placesBinding, PlaceBlock, places)
INPUT_ARRAY(beginsBinding, BeginBlock, begins)
INPUT_ARRAY(speedsBinding, SpeedBlock, speeds)
INPUT_WORDS(listsBinding, ListBlock, lists)
STATE_WORDS(choosesBinding, ChoiceBlock, choices)

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  float radius = LOAD_INPUT(begins, s).w;
  BallPath here = ballPath(LOAD_INPUT(places, s), LOAD_INPUT(speeds, s));
  BallImpact best;
  best.time = -1.0f;
  best.speed = 0.0f;
  uint bestTie = 0u;
  int partner = s;
  int listed = radius > 0.0f ? stepData.balls.listed : 0;
  for (int k = 0; k < listed; k += 4) {
    uvec4 four = LOAD_INPUT_WORDS(lists, (k >> 2) * stepData.count + s);
    for (int c = 0; c < 4; ++c) {
      int j = int(wordAt(four, c));
      if (j == s) continue;  // As a condition of the loop, NVIDIA's compiler drops this test
      precise float reach = radius + LOAD_INPUT(begins, j).w;
      BallImpact hit = ballImpact(here, ballPath(LOAD_INPUT(places, j), LOAD_INPUT(speeds, j)), reach);
      uint tie = ballTie(s, j);
      if (!ballSooner(hit, best, tie, bestTie)) continue;
      best = hit;
      bestTie = tie;
      partner = j;
    }
    if (int(four.w) == s) break;
  }
  STORE_WORDS(choices, s, uvec4(uint(partner), 0u, 0u, 0u));
}
