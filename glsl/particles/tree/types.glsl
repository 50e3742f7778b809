// Layout of the gravity tree. Compiles as GLSL and as C++ (src/sim/particles/gravity_tree.cpp, the CPU twin).
//
// Bodies are sorted along a Hilbert curve and divided into leaves of 8 bodies. Every 4096 leaves form a complete binary
// tree without pointers: node 1 is the root, node h has the children 2h and 2h + 1, and the nodes 4096 to 8191 are the
// leaves. A set of bodies is a sequence of such trees. A tree is so small that opening all of its nodes takes fewer
// than 65,535 loop iterations, the limit of software drivers per invocation.
#ifndef TREE_TYPES
#define TREE_TYPES

const int leafBodies = 8;
const int rootLeaves = 4096;
const int rootNodes = 8192;   // Number of nodes per tree; node 0 is unused
const int rootBodies = 32768;
const int groupBodies = 64;   // Number of bodies that walk the tree together; a power of two times leafBodies
// Number of bits in each of the two words of a sort key: 8 subdivisions of space with three bits each
const int keyBits = 24;

#endif
