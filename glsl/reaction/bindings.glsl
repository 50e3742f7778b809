// Binding points of the arrays of a rule's kernels. An array consists of planes. A plane has rows of elements with four
// cells each.
const int stageBinding = 0;    // Species values at which rates are evaluated
const int baseBinding = 1;     // Species values at the start of the step
const int sumBinding = 2;      // Sum over the stages of a step
const int letsBinding = 3;     // Values that the passes of a stage store for later passes
const int weightsBinding = 4;  // Maps of parameters
const int nextBinding = 5;     // Species values after the stage
const int stampsBinding = 6;   // Bit masks of brush images
const int linksBinding = 6;    // Links of a mesh's cells. First, one element per element of four cells: x start and y
                               // end of its links. Then, two elements per link: the neighbour indices of four cells,
                               // and the weights as float bits.
