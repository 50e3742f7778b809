// Copies the particles in sorted order, and stores for each bucket the range of its particles in that order. One
// invocation per slot.
#include "particles/contact/kernel.glsl"
INPUT_ARRAY(placesBinding, PositionBlock, positions)
INPUT_ARRAY(ballStartsBinding, StartBlock, starts)
INPUT_ARRAY(ballVelocitiesBinding, VelocityBlock, velocities)
INPUT_WORDS(recordsBinding, RecordBlock, records)
OUTPUT_ARRAY(guessesBinding, GuessBlock, guesses)
STATE_ARRAY(beginsBinding, BeginBlock, begins)
STATE_ARRAY(speedsBinding, SpeedBlock, speeds)
STATE_WORDS(tableBinding, TableBlock, table)
#ifdef ROLLS
INPUT_ARRAY(rollsBinding, SpinBlock, spins)
OUTPUT_ARRAY(nextRollsBinding, NextSpinBlock, nextSpins)
#endif
uniform int stamp;  // Serial number of this search; ranges of earlier searches in the table are ignored

void main() {
  int s = int(gl_GlobalInvocationID.x);
  if (s >= stepData.count) return;
  uvec4 record = LOAD_INPUT_WORDS(records, s);
  int i = int(record.z);
  vec4 here = LOAD_INPUT(positions, i);
  bool alive = record.x != uint(stepData.balls.tableMask);
  vec4 speed = LOAD_INPUT(velocities, i);
  ivec2 place = ringPlace(i);
  vec3 from = place.y >= 0 ? here.xyz : LOAD_INPUT(starts, i).xyz;
  precise float radius = ballRadius(here.w) * ballGrowth(place.x, speed.w);
  STORE_STATE(guesses, s, here);
  STORE_STATE(begins, s, vec4(from, alive ? radius : 0.0f));
  STORE_STATE(speeds, s, speed);
#ifdef ROLLS
  precise vec3 spin = LOAD_INPUT(spins, i).xyz * radius;
  STORE_STATE(nextSpins, s, vec4(alive && place.y < 0 ? spin : vec3(0.0f), 0.0f));
#endif
  if (!alive || (s > 0 && LOAD_INPUT_WORDS(records, s - 1).x == record.x)) return;
  int end = s + 1;
  int last = min(s + ballRun, stepData.count);
  while (end < last && LOAD_INPUT_WORDS(records, end).x == record.x) ++end;
  STORE_WORDS(table, int(record.x), uvec4(uint(s), uint(end), uint(stamp), 0u));
}
