// A solid that others collide with (wall_model.glsl). Compiles as GLSL and as C++ (src/sim/contour/wall_plan.hpp). Set as
// plain uniforms, one member at a time.
#ifndef WALL_TYPES
#define WALL_TYPES

// Of the kernels that read them: beside what cloth and particles have.
const int wallClassesBinding = 4;
const int wallFieldUnit = 8;
const int maxWallLevels = 16;

struct WallGrid {
  vec2 corner;       // x and z of sample (0, 0) (m)
  float spacing;     // between samples (m)
  float perSpacing;  // 1/m
  float bottom;      // m
  float roof;        // top of the rock above a ceiling (m)
  float reach;       // kept from the solid (m)
  float kept;        // fraction of the tangential velocity
  float bounce;      // fraction of the speed of impact that is given back
  int levelCount;
  int ceiling;       // 1: there is one
  int squares;       // around a point's own within which walls are at most `reach` away
  ivec2 samples;     // the field's size + 2
  float heights[maxWallLevels + 1];  // of the classes (m)
  float levels[maxWallLevels];
};

#endif
