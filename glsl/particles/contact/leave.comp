// Computes the velocities with which balls leave their contacts, and writes the positions and velocities back to the
// particles. One invocation per ball.
#include "particles/contact/kernel.glsl"
#include "particles/contact/leave.glsl"
INPUT_ARRAY(placesBinding, PlaceBlock, places)
INPUT_ARRAY(beginsBinding, BeginBlock, begins)
INPUT_ARRAY(guessesBinding, GuessBlock, guesses)
INPUT_ARRAY(struckBinding, StruckBlock, struck)
INPUT_ARRAY(speedsBinding, SpeedBlock, speeds)
INPUT_WORDS(listsBinding, ListBlock, lists)
INPUT_WORDS(recordsBinding, RecordBlock, records)
STATE_ARRAY(nextBinding, PositionBlock, positions)
STATE_ARRAY(ballVelocitiesBinding, VelocityBlock, velocities)
#ifdef ROLLS
INPUT_ARRAY(rollsBinding, RollBlock, rolls)
OUTPUT_ARRAY(nextRollsBinding, SpinBlock, spins)
STATE_ARRAY(turnsBinding, TurnBlock, turns)
#endif

BallMotion motionOf(int s) {
  return ballMotion(LOAD_INPUT(struck, s).xyz, LOAD_INPUT(speeds, s).xyz, LOAD_INPUT(places, s));
}

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  vec4 begin = LOAD_INPUT(begins, s);
  if (begin.w <= 0.0f) return;
  float mass = LOAD_INPUT(guesses, s).w;
  float perMass = exactReciprocal(max(mass, 1e-30f));
  BallMotion here = motionOf(s);
  BallLeaving leaving = ballLeaving(here);
  for (int k = 0; k < stepData.balls.listed; k += 4) {
    uvec4 four = LOAD_INPUT_WORDS(lists, (k >> 2) * stepData.count + s);
    for (int c = 0; c < 4; ++c) {
      int j = int(wordAt(four, c));
      if (j == s) continue;  // As a condition of the loop, NVIDIA's compiler drops this test
      precise float reach = begin.w + LOAD_INPUT(begins, j).w;
      leaving = ballBounce(leaving, here, motionOf(j), reach, perMass, s, j);
    }
    if (int(four.w) == s) break;
  }
  vec3 place = here.place.xyz;
  vec3 velocity = ballLeft(leaving, here);
  bool rests = leaving.touches && ballRests(begin.xyz, place, velocity);
  if (rests) {
    place = begin.xyz;
    velocity = ballIdle(velocity);
  }
  int i = int(LOAD_INPUT_WORDS(records, s).z);
#ifdef ROLLS
  vec3 spin = ballSpin(LOAD_INPUT(rolls, s).xyz, begin.w);
  if (rests) spin = ballIdle(spin);
  vec4 turn = ringPlace(i).y < 0 ? LOAD_ONCE(turns, i) : vec4(0.0f, 0.0f, 0.0f, 1.0f);
  STORE_STATE(spins, i, vec4(spin, 0.0f));
  STORE_STATE(turns, i, ballTurned(turn, rests ? vec3(0.0f) : spin));
#endif
  STORE_STATE(positions, i, vec4(place, mass));
  STORE_STATE(velocities, i, vec4(velocity, LOAD_INPUT(speeds, s).w));
}
