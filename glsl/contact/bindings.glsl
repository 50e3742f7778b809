// Binding points and array sections of the contact kernels. Compiles as GLSL and as C++ (src/sim/contact).
#ifndef CONTACT_BINDINGS
#define CONTACT_BINDINGS

const int pointsBinding = 0;    // One vec4 per vertex in each of these sections:
const int nowSection = 0;       // xyz position at the substep's start; w inverse mass (0: pinned)
const int nextSection = 1;      // xyz position predicted without contact; w half the thickness
const int wantedSection = 2;    // xyz position after the contact impulses
const int lowSection = 3;       // xyz low corner of the box within which the found pairs remain complete
const int highSection = 4;      // xyz high corner; w is 1 if a pair with a solid or a ball has been found
const int skinSection = 5;      // x half the thickness, or a ball's radius; y friction; z a ball's bounce; w for a
                                // cloth its index, for a ball the index of the cloth that it touches (-1: all cloths)
// xyz position to which the vertex can be held back: the substep's start, or the position to which solids carry it
const int startSection = 6;
const int pointSections = 7;
const int talliesBinding = 4;   // One ivec4 per vertex in each of these sections:
const int impulseSection = 0;   // xyz sum of impulses; w sum of claims
// Allowed fraction of the vertex's path, as float bits: xyz in hold rounds 0 to 2, w if all separating planes are at
// rest
const int letSection = 1;
// xyz displacement by solids along the positive axes, as float bits; w for a ball the distance to its nearest feature
const int upSection = 2;
const int downSection = 3;      // xyz displacement along the negative axes
const int tallySections = 4;
const int toldBinding = 2;      // The tallies as a texel buffer
const int controlBinding = 5;   // Counts, and arguments of indirect dispatches
const int boxesBinding = 1;     // Boxes of a tree: two vec4 per node
const int leavesBinding = 2;    // uvec4: corners of a face, or ends of an edge; w is 1 for an empty leaf
const int pairsBinding = 3;     // ivec4: first the vertex-face pairs, then the edge-edge pairs
const int candidatesBinding = 6;  // Candidate pairs, in the format of the pairs
const int cornersBinding = 6;   // ivec4: corners of each near pair
const int nearsBinding = 1;     // Three vec4 per near pair: barycentric weights, normal, correction
const int partNowBinding = 1;   // Positions of one participating simulation
const int partNextBinding = 2;
const int partVelocitiesBinding = 3;

const int beginBinding = 1;     // Solid's vertices in object space at the frame's begin
const int endBinding = 2;       // Solid's vertices in object space at the frame's end
const int placesBinding = 3;

// Indices of indirect dispatches. Each takes four words of the control buffer, after countWords.
const int vertexDispatch = 0;
const int faceDispatch = 1;     // Dispatch over the leaves of the face tree
const int edgeDispatch = 5;     // Dispatch over the leaves of the edge tree
const int vertexPairDispatch = 2;
const int edgePairDispatch = 3;
const int nearDispatch = 4;
const int vertexCandidateDispatch = 6;
const int edgeCandidateDispatch = 7;
// Dispatches over near pairs, and over vertices (startDispatch); empty unless solids or balls move
const int carryDispatch = 8;
const int startDispatch = 9;
const int levelDispatch = 10;    // First of the per-level dispatches of the trees; the root is level 0
const int maxLevels = 24;
const int countWords = 12;

#endif
