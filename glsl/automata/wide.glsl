// What a count means in Larger than Life. Defines: STATES, MIDDLE (1: a cell counts itself), SURVIVE_MIN, SURVIVE_MAX,
// BORN_MIN, BORN_MAX.
#include "automata/next.glsl"

uint wideNext(uint state, int total) {
  int count = total - (MIDDLE == 0 && state == 1u ? 1 : 0);
  bool survives = count >= SURVIVE_MIN && count <= SURVIVE_MAX;
  bool born = count >= BORN_MIN && count <= BORN_MAX;
  return agedState(state, state == 0u ? born : survives, uint(STATES));
}
