// Lets those pairs of balls collide that have chosen each other, and moves the balls out of solids. One ball per
// invocation.
#define BALLS
#include "particles/kernel.glsl"
#include "common/words.glsl"
#include "particles/contact/bindings.glsl"
#include "particles/contact/impact.glsl"
INPUT_ARRAY(placesBinding, PlaceBlock, places)
INPUT_ARRAY(beginsBinding, BeginBlock, begins)
INPUT_ARRAY(guessesBinding, GuessBlock, guesses)
INPUT_ARRAY(pathSpeedsBinding, SpeedBlock, speeds)
INPUT_WORDS(choicesBinding, ChoiceBlock, choices)
STATE_ARRAY(nextBinding, NextBlock, nextPlaces)
OUTPUT_ARRAY(nextSpeedsBinding, NextSpeedBlock, nextSpeeds)
#ifdef ROLLS
INPUT_ARRAY(rollsBinding, SpinBlock, spins)
OUTPUT_ARRAY(nextRollsBinding, NextSpinBlock, nextSpins)
vec3 spinOfBall(int s) {
  return LOAD_INPUT(spins, s).xyz;
}
#else
vec3 spinOfBall(int s) {
  return vec3(0.0f);
}
#endif

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  vec4 place = LOAD_INPUT(places, s);
  vec4 speed = LOAD_INPUT(speeds, s);
  vec3 spin = spinOfBall(s);
  int j = int(LOAD_INPUT_WORDS(choices, s).x);
  if (j != s && int(LOAD_INPUT_WORDS(choices, j).x) == s) {
    vec4 begin = LOAD_INPUT(begins, s);
    precise float reach = begin.w + LOAD_INPUT(begins, j).w;
    float mass = LOAD_INPUT(guesses, s).w;
    float perMass = exactReciprocal(max(mass, 1e-30f));
    float otherPerMass = exactReciprocal(max(LOAD_INPUT(guesses, j).w, 1e-30f));
    BallPath here = ballPath(place, speed);
    BallImpact hit = ballImpact(here, ballPath(LOAD_INPUT(places, j), LOAD_INPUT(speeds, j)), reach);
    BallStruck after = ballStruck(here, hit, perMass, otherPerMass, spin, spinOfBall(j));
    ParticleMotion m = particleMotion(vec4(after.path.end, mass), vec4(after.path.velocity, speed.w));
#ifdef ROLLS
    precise vec3 roll = after.spin * stepData.dt;
    m.spin = after.spin;
    m.roll = roll;
#endif
    if (SOLIDS == 1) m = outOfSolids(m, begin.xyz);
    if (HEIGHTS == 1) m = overHeights(m);
    if (WALLS == 1) m = besideWalls(m, begin.xyz);
    place = vec4(m.position.xyz, place.w);
    speed = m.velocity;
#ifdef ROLLS
    spin = m.spin;
#endif
  }
  STORE_STATE(nextPlaces, s, place);
  STORE_STATE(nextSpeeds, s, speed);
#ifdef ROLLS
  STORE_STATE(nextSpins, s, vec4(spin, 0.0f));
#endif
}
