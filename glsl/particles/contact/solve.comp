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
#ifdef ROLLS
INPUT_ARRAY(rollsBinding, RollBlock, rolls)
OUTPUT_ARRAY(nextRollsBinding, NextRollBlock, nextRolls)
uniform float perRoll;  // Factor that makes the elements of `rolls` angles of the substep: dt, or 1 after an iteration
vec3 rollOf(int s) {
  precise vec3 roll = LOAD_INPUT(rolls, s).xyz * perRoll;
  return roll;
}
#else
vec3 rollOf(int s) {
  return vec3(0.0f);
}
#endif
#include "particles/contact/model.glsl"
#include "particles/contact/push.glsl"

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  Ball here = Ball(LOAD_INPUT(places, s), LOAD_INPUT(begins, s));
  float mass = LOAD_INPUT(guesses, s).w;
  if (here.start.w <= 0.0f) {
    STORE_STATE(nextPlaces, s, here.place);
#ifdef ROLLS
    STORE_STATE(nextRolls, s, vec4(0.0f));
#endif
    return;
  }
  float perMass = exactReciprocal(max(mass, 1e-30f));
  precise vec3 sum = vec3(0.0f);
  vec3 roll = rollOf(s);
  precise vec3 turned = roll;
  for (int k = 0; k < stepData.balls.listed; k += 4) {
    uvec4 four = LOAD_INPUT_WORDS(lists, (k >> 2) * stepData.count + s);
    for (int c = 0; c < 4; ++c) {
      int j = int(wordAt(four, c));
      if (j == s) continue;  // As a condition of the loop, NVIDIA's compiler drops this test
      Ball other = Ball(LOAD_INPUT(places, j), LOAD_INPUT(begins, j));
      precise vec3 rolls_ = roll + rollOf(j);
      BallPush push = ballPush(here, other, perMass, s, j, rolls_);
      sum = sum + push.way;
      turned = turned + push.roll;
    }
    if (int(four.w) == s) break;
  }
  precise vec3 place = here.place.xyz + ballPushes(sum, here.start.w);
  ParticleMotion m = particleMotion(vec4(place, mass), vec4(0.0f));
#ifdef ROLLS
  m.roll = turned;
#endif
  if (SOLIDS == 1) m = outOfSolids(m, here.start.xyz);
  if (HEIGHTS == 1) m = overHeights(m);
  if (WALLS == 1) m = besideWalls(m, here.start.xyz);
  STORE_STATE(nextPlaces, s, vec4(m.position.xyz, here.place.w));
#ifdef ROLLS
  STORE_STATE(nextRolls, s, vec4(m.roll, 0.0f));
#endif
}
