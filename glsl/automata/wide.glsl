// Rule of Larger than Life, applied to a count. Defines: STATES; MIDDLE is 1 if a cell counts itself; SURVIVES and BORN
// are conditions on `count` for cells of state 1 and of state 0.
#include "automata/next.glsl"

uint wideNext(uint state, int total) {
  int count = total - (MIDDLE == 0 && state == 1u ? 1 : 0);
  bool survives = SURVIVES;
  bool born = BORN;
  return agedState(state, state == 0u ? born : survives, uint(STATES));
}
