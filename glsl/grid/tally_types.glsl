// What is summed up over a field, and the most of it. Compiles as GLSL and as C++ (src/sim/grid/tally.hpp).
const int tallyLanes = 16384;  // sums of the first round; so many that none has more than 65,535 cells
const int tallyJoined = 128;   // of those that one of the next round joins, and of that the last
const int sumsOutBinding = 4;  // sums and most of a lane, an element each
const int sumsInBinding = 3;
