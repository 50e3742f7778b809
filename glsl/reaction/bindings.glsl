// Binding points of the arrays of a rule's kernels. An array consists of planes; a plane has rows of elements with four
// cells each.
const int stageBinding = 0;    // Species at which rates are evaluated
const int baseBinding = 1;     // Species at the step's start
const int sumBinding = 2;      // Sum over the stages of a step
const int letsBinding = 3;     // Values that the passes of a stage leave for later passes
const int weightsBinding = 4;  // Maps of parameters
const int nextBinding = 5;     // Species after the stage
const int stampsBinding = 6;   // Bit images of brushes
const int linksBinding = 6;    // Links of a mesh's cells: per element x begin and y end of its links; then per link of
                               // four cells two elements: neighbour indices, weights as float bits
