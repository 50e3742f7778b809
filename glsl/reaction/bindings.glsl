// Arrays of a rule's kernels: planes of rows of elements, four cells each.
const int stageBinding = 0;    // species where rates are asked for
const int baseBinding = 1;     // species at the step's beginning
const int sumBinding = 2;      // what the stages of a step have summed up
const int letsBinding = 3;     // what the passes of a stage leave for those after
const int weightsBinding = 4;  // maps of parameters
const int nextBinding = 5;     // species that come of it
const int stampsBinding = 6;   // of brushes
const int linksBinding = 6;    // of a mesh's cells: of each element x begin and y end of its links, then links of four cells by
                               // two: numbers of neighbours, weights as bits
