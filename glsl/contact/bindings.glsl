// Binding points and array sections of the contact kernels. Compiles as GLSL and as C++ (src/sim/contact).
#ifndef CONTACT_BINDINGS
#define CONTACT_BINDINGS

const int pointsBinding = 0;    // Sections of the array of points. Each section holds one vec4 per vertex.
const int nowSection = 0;       // xyz position at the substep's start in metres; w inverse mass in 1/kg (0 if pinned)
const int nextSection = 1;      // xyz position predicted without contact; w half the thickness
const int wantedSection = 2;    // xyz position after the contact impulses
const int lowSection = 3;       // xyz minimum corner of the vertex's box: the found pairs remain complete while the
                                // vertex stays inside
const int highSection = 4;      // xyz maximum corner of the box; w is 1 if a pair of the vertex with a solid or a ball
                                // has been found
const int skinSection = 5;      // x half the thickness, or a ball's radius; y friction coefficient; z a ball's bounce;
                                // w a cloth's index, or for a ball the index of the cloth that it touches (-1 for all
                                // cloths)
// xyz position to which the vertex can be held back: its position at the substep's start, or the position to which
// solids carry it
const int startSection = 6;
const int pointSections = 7;
const int talliesBinding = 4;   // Sections of the array of tallies. Each section holds one ivec4 per vertex.
const int impulseSection = 0;   // xyz sum of impulses; w sum of claims (see massWeightOf() in model.glsl)
// Allowed fraction of the vertex's path, as float bits: xyz in hold rounds 0 to 2, w if all separating planes stand
// still
const int letSection = 1;
// xyz displacement by solids along the positive axes, as float bits; for a ball, w is the distance to its nearest
// feature
const int upSection = 2;
const int downSection = 3;      // xyz displacement by solids along the negative axes, as float bits
const int tallySections = 4;
const int tallyTexelsBinding = 2;      // The array of tallies as a texel buffer
const int controlBinding = 5;   // Counts and arguments of indirect dispatches
const int boxesBinding = 1;     // Boxes of a tree: two vec4 per node
const int leavesBinding = 2;    // uvec4 per leaf: corners of a face, or ends of an edge; w is 1 if the leaf is empty
const int pairsBinding = 3;     // ivec4 per pair: first the vertex-face pairs, then the edge-edge pairs
const int candidatesBinding = 6;  // Candidate pairs in the same format as the pairs
const int cornersBinding = 6;   // ivec4 per near pair: its corners
const int nearsBinding = 1;     // Three vec4 per near pair: barycentric weights, normal, correction
const int partNowBinding = 1;   // Positions of one of the simulations in contact
const int partNextBinding = 2;
const int partVelocitiesBinding = 3;

const int beginBinding = 1;     // Vertices of a solid in object space at the start of the frame
const int endBinding = 2;       // Vertices of a solid in object space at the end of the frame
const int placesBinding = 3;

// Indices of the indirect dispatches. Each dispatch has four words in the control buffer, which follow its first
// countWords words.
const int vertexDispatch = 0;
const int faceDispatch = 1;     // Dispatch over the leaves of the face tree
const int edgeDispatch = 5;     // Dispatch over the leaves of the edge tree
const int vertexPairDispatch = 2;
const int edgePairDispatch = 3;
const int nearDispatch = 4;
const int vertexCandidateDispatch = 6;
const int edgeCandidateDispatch = 7;
// carryDispatch runs over the near pairs and startDispatch over the vertices. Both are empty unless solids or balls
// move.
const int carryDispatch = 8;
const int startDispatch = 9;
const int levelDispatch = 10;    // First of the dispatches for the levels of the trees; the root is level 0
const int maxLevels = 24;
const int countWords = 12;

#endif
