// Computes one iteration over all contacts: moves each ball by the sum of its neighbours' corrections, then out of
// solids. One invocation per ball.
#define BALLS
#include "particles/kernel.glsl"
#include "common/words.glsl"
#include "particles/contact/bindings.glsl"
INPUT_ARRAY(placesBinding, PlaceBlock, places)
INPUT_ARRAY(beginsBinding, BeginBlock, begins)
INPUT_ARRAY(guessesBinding, GuessBlock, guesses)
INPUT_WORDS(listsBinding, ListBlock, lists)
STATE_ARRAY(nextBinding, NextBlock, nextPlaces)
#include "particles/contact/model.glsl"
#include "particles/contact/push.glsl"

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  Ball here = Ball(LOAD_INPUT(places, s), LOAD_INPUT(begins, s));
  float mass = LOAD_INPUT(guesses, s).w;
  if (here.start.w <= 0.0f) {
    STORE_STATE(nextPlaces, s, here.place);
    return;
  }
  float perMass = exactReciprocal(max(mass, 1e-30f));
  precise vec3 sum = vec3(0.0f);
  for (int k = 0; k < stepData.balls.listed; k += 4) {
    uvec4 four = LOAD_INPUT_WORDS(lists, (k >> 2) * stepData.count + s);
    for (int c = 0; c < 4; ++c) {
      int j = int(four[c]);
      if (j == s) continue;  // As a condition of the loop, NVIDIA's compiler drops this test
      sum = sum + ballPush(here, Ball(LOAD_INPUT(places, j), LOAD_INPUT(begins, j)), perMass, s, j);
    }
    if (int(four.w) == s) break;
  }
  precise vec3 place = here.place.xyz + ballPushes(sum, here.start.w);
  ParticleMotion m = ParticleMotion(vec4(place, mass), vec4(0.0f));
  if (SOLIDS == 1) m = outOfSolids(m, here.start.xyz);
  if (HEIGHTS == 1) m = overHeights(m);
  if (WALLS == 1) m = besideWalls(m, here.start.xyz);
  STORE_STATE(nextPlaces, s, vec4(m.position.xyz, here.place.w));
}
