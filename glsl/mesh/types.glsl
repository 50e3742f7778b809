// What the deformation of a mesh is told of one moment, in the mesh's own space. Compiles as GLSL and as C++
// (src/sim/mesh/deform_parameters.hpp), where members with a default are what a scene says. std140.
#ifndef DEFORM_TYPES
#define DEFORM_TYPES

const int maxDisplacements = 16;
const int maxPressers = 12;
const int rippleKind = 0;
const int waveKind = 1;
const int swayKind = 2;
const int footprintsKind = 3;
const int pushKind = 4;

struct STD140 RippleStep {
  vec4 centre DEFAULT(vec4(0.0f));  // xyz (m)
  float amplitude DEFAULT(0.25f);   // m
  float decay DEFAULT(0.0f);        // 1/m
  float wavenumber;                 // 1/m
  float phase;
};

struct STD140 WaveStep {
  vec2 heading;                    // x and z, unit
  float amplitude DEFAULT(0.05f);  // m
  float surge;                     // forwards and backwards (m)
  float wavenumber;                // 1/m
  float phase;
};

struct STD140 SwayStep {
  vec2 heading;                   // x and z, unit
  float amplitude DEFAULT(0.2f);  // m
  float base DEFAULT(0.0f);       // m
  float perHeight;                // 1/m
  float lean DEFAULT(0.4f);       // constant fraction of the amplitude
  float gusts DEFAULT(0.6f);      // changing fraction of it
  float wavenumber;               // of the gusts (1/m)
  vec4 phases;                    // three of them
};

struct STD140 PushStep {
  float softness DEFAULT(0.2f);  // m
  float base DEFAULT(0.0f);      // m
  float perHeight;               // 1/m; 0: all of it gives way
};

// Only the member of its kind counts; footprints have none.
struct STD140 Displacement {
  RippleStep ripple;
  WaveStep wave;
  SwayStep sway;
  PushStep push;
  int kind;
};

// Prints of what moves, kept on a grid of cells.
struct STD140 TrailStep {
  ivec2 cells DEFAULT(ivec2(512, 512));  // along x and z
  vec2 corner;                           // x and z of the middle of cell (0, 0) (m)
  vec2 cellSize;                         // m
  vec2 perCell;                          // 1/m
  float height DEFAULT(0.0f);            // of the surface that is pressed (m)
  float depth DEFAULT(0.2f);             // of the deepest print (m)
  float rim DEFAULT(0.25f);              // height beside a print as a fraction of its depth
  float perRimWidth;                     // 1/m
};

// A solid sphere or capsule: the points around a segment.
struct STD140 Presser {
  vec4 start;        // xyz (m)
  vec4 end;          // xyz (m)
  float radius;      // m
  float perLength2;  // 1/|end - start|^2, 0 for a sphere
  float perFlat2;    // the same seen from above, 0 where it is a point
};

struct STD140 DeformStep {
  TrailStep trail;
  Displacement displacements[maxDisplacements];
  Presser pressers[maxPressers];
  int displacementCount;
  int presserCount;
  int vertexCount;
};

#endif
