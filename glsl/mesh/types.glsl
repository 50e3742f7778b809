// Parameters of a mesh's deformation at a given time, in the mesh's object space, in std140 layout. Compiles as GLSL
// and as C++ (src/sim/mesh/deform_parameters.hpp), where members with a default are scene parameters.
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
  vec4 centre DEFAULT(vec4(0.0f));  // xyz position, m
  float amplitude DEFAULT(0.25f);   // Amplitude in metres
  float decay DEFAULT(0.0f);        // Decay rate with the distance in 1/m
  float wavenumber;                 // Angular wavenumber in 1/m
  float phase;
};

struct STD140 WaveStep {
  vec2 heading;                    // Horizontal direction (x, z), unit vector
  float amplitude DEFAULT(0.05f);  // Amplitude in metres
  float surge;                     // Amplitude of the horizontal motion, m
  float wavenumber;                // Angular wavenumber in 1/m
  float phase;
};

struct STD140 SwayStep {
  vec2 heading;                   // Horizontal direction (x, z), unit vector
  float amplitude DEFAULT(0.2f);  // Amplitude in metres
  float base DEFAULT(0.0f);       // Height of the base in metres
  float perHeight;                // 1 / height of the shape, in 1/m
  float lean DEFAULT(0.4f);       // Constant part of the shift, as a fraction of the amplitude
  float gusts DEFAULT(0.6f);      // Varying part of the shift, as a fraction of the amplitude
  float wavenumber;               // Angular wavenumber of the gusts, 1/m
  vec4 phases;                    // Phases of the three gust waves
};

struct STD140 PushStep {
  float softness DEFAULT(0.2f);  // Distance in metres over which the effect fades out
  float base DEFAULT(0.0f);      // Height of the base in metres
  float perHeight;               // 1 / height, 1/m; if 0, the effect does not depend on the height
};

// Displacement of one kind. Only the member of this kind is used; footprints use no member.
struct STD140 Displacement {
  RippleStep ripple;
  WaveStep wave;
  SwayStep sway;
  PushStep push;
  int kind;
};

// Grid of cells that stores the prints of pressers.
struct STD140 TrailStep {
  ivec2 cells DEFAULT(ivec2(512, 512));  // Number of cells along x and z
  vec2 corner;                           // x and z of the centre of cell (0, 0), m
  vec2 cellSize;                         // Width of a cell along x and z in metres
  vec2 perCell;                          // 1 / cell width along x and z, in 1/m
  float height DEFAULT(0.0f);            // Height of the surface before it is pressed, m
  float depth DEFAULT(0.2f);             // Maximum depth of a print, m
  float rim DEFAULT(0.25f);              // Height of the rim as a fraction of the print's depth
  float perRimWidth;                     // 1 / width of the rim, 1/m
};

// Presser: a sphere, or a capsule around a segment.
struct STD140 Presser {
  vec4 start;        // xyz start of the segment, m
  vec4 end;          // xyz end of the segment, m
  float radius;      // Radius in metres
  float perLength2;  // 1/|end - start|^2, or 0 for a sphere
  float perFlat2;    // 1 / squared horizontal length, 1/m^2; 0 if the segment is vertical or a point
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
