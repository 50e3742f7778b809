// What a count means in Larger than Life. Defines: STATES, MIDDLE (1: a cell counts itself), SURVIVES and BORN, which say
// of `count` whether a cell of state 1 stays so and one of state 0 becomes 1.
#include "automata/next.glsl"

uint wideNext(uint state, int total) {
  int count = total - (MIDDLE == 0 && state == 1u ? 1 : 0);
  bool survives = SURVIVES;
  bool born = BORN;
  return agedState(state, state == 0u ? born : survives, uint(STATES));
}
