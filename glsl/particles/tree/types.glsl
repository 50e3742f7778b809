// The shape of the gravity tree. Compiles as GLSL and as C++ (src/sim/particles/gravity_tree.cpp, the CPU twin).
//
// Bodies are sorted along a Hilbert curve and cut into leaves of 8. Above every 4096 leaves stands a complete
// binary tree without pointers: node 1 is its root, node h has the children 2h and 2h + 1, and the nodes
// 4096..8191 are the leaves. A set of bodies is a row of such trees. Each tree is small enough that opening
// all of it takes fewer than the 65,535 loop iterations that software drivers allow an invocation.
#ifndef TREE_TYPES
#define TREE_TYPES

const int leafBodies = 8;
const int rootLeaves = 4096;
const int rootNodes = 8192;   // the nodes of a tree, node 0 unused
const int rootBodies = 32768;
const int groupBodies = 64;   // neighbours that walk the tree together; leafBodies times a power of two
const int keyBits = 24;       // of each of the two words of a sort key: 8 halvings of space, three bits each

#endif
