// Where the kernels of contact find their arrays. Compiles as GLSL and as C++ (src/sim/contact).
#ifndef CONTACT_BINDINGS
#define CONTACT_BINDINGS

const int pointsBinding = 0;    // vec4 a vertex in each of these sections:
const int nowSection = 0;       // xyz at the substep's start, w inverse mass (0: held)
const int nextSection = 1;      // xyz where it would go, w half the thickness
const int wantedSection = 2;    // xyz after the contacts' impulses
const int lowSection = 3;       // xyz the box in which pairs stay good,
const int highSection = 4;      // w 1: a solid may come near it while they do
const int skinSection = 5;      // x half the thickness, or of a ball its radius; y friction; z bounce of a ball; w the cloth that it meets
                                // (-1: any), of a cloth its number
const int startSection = 6;     // xyz from where it may be held back: where it was, or as far as solids carry it
const int pointSections = 7;
const int talliesBinding = 4;   // ivec4 a vertex in each of these sections:
const int impulseSection = 0;   // xyz sum of impulses, w of claims
const int letSection = 1;       // how far it may go, as floats' bits: in the first three rounds, and with everything at rest
const int upSection = 2;        // xyz how far solids carry it along each axis, as floats' bits; w of a ball how near the nearest is,
const int downSection = 3;      // and against it
const int tallySections = 4;
const int toldBinding = 2;      // the same as texels
const int controlBinding = 5;   // counts and arguments of dispatches
const int boxesBinding = 1;     // two vec4 a node, of a tree
const int leavesBinding = 2;    // uvec4: corners of a face or ends of an edge; w 1: neither
const int pairsBinding = 3;     // ivec4: first those of vertices with faces, then those of edges
const int candidatesBinding = 6;  // the same, of which pairs are some
const int cornersBinding = 6;   // ivec4 of what is near
const int nearsBinding = 1;     // three vec4 of what is near: shares, normal, way
const int partNowBinding = 1;   // of a simulation that takes part
const int partNextBinding = 2;
const int partVelocitiesBinding = 3;

const int beginBinding = 1;     // of a solid: vertices in its own space, at the frame's beginning
const int endBinding = 2;       // and at its end
const int placesBinding = 3;

// Dispatches whose size kernels decide, four words of control each, after its counts.
const int vertexDispatch = 0;
const int faceDispatch = 1;     // leaves of the tree over faces
const int edgeDispatch = 5;     // and of that over edges
const int vertexPairDispatch = 2;
const int edgePairDispatch = 3;
const int nearDispatch = 4;
const int vertexCandidateDispatch = 6;
const int edgeCandidateDispatch = 7;
const int carryDispatch = 8;    // what is near, where solids move, and vertices
const int startDispatch = 9;
const int levelDispatch = 10;    // one a level of a tree, from the root's on
const int maxLevels = 24;
const int countWords = 12;

#endif
