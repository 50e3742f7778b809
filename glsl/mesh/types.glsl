// What the deformation of a mesh is told of one moment, in the mesh's own space. Compiles as GLSL and as C++
// (src/sim/mesh/deform_plan.hpp). Only 16-byte members, so std140 and std430 agree.
#ifndef DEFORM_TYPES
#define DEFORM_TYPES

const int mostDisplacements = 16;
const int mostPressers = 12;
const int rippleKind = 0;
const int waveKind = 1;
const int swayKind = 2;
const int footprintsKind = 3;
const int pushKind = 4;

// What a, b and c mean is said beside each function of model.glsl.
struct Displacement {
  ivec4 kind;  // x one of the kinds
  vec4 a;
  vec4 b;
  vec4 c;
};

// A solid sphere or capsule: the points around the segment a-b.
struct Presser {
  vec4 a;  // xyz start (m), w radius (m)
  vec4 b;  // xyz end (m), w 1/|b-a|^2, 0 for a sphere
  vec4 c;  // x 1/|b-a|^2 of the segment seen from above, 0 where it is a point
};

struct DeformStep {
  ivec4 counts;      // displacements, pressers, vertices, spare
  ivec4 trailCells;  // cells of the trail along x and z
  vec4 trailPlace;   // xy: x and z of the middle of cell (0, 0) (m); zw: 1/size of a cell (1/m)
  vec4 trailShape;   // xy: size of a cell (m); z: height of the surface that is pressed (m); w: deepest print (m)
  vec4 trailRim;     // x: height of the rim as a share of the print's depth; y: 1/width of the rim (1/m)
  Displacement displacements[mostDisplacements];
  Presser pressers[mostPressers];
};

#endif
