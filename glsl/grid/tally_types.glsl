// Types and constants of tallies: sums and maxima over all cells of a field. Compiles as GLSL and as C++
// (src/sim/grid/tally.hpp).
const int tallyLanes = 16384;  // Number of partial sums in the first round; it is so large that each of them sums at
                               // most 65,535 cells
// Number of partial sums that one lane of the second round combines; also the number that the last round combines
const int tallyJoined = 128;
const int sumsOutBinding = 4;  // Two elements per lane: sums, maxima
const int sumsInBinding = 3;
