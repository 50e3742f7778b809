// Uniform data of a solid with which cloth and particles collide (wall_model.glsl). Compiles as GLSL and as C++
// (src/sim/contour/wall_plan.hpp). The members are set as plain uniforms, one at a time.
#ifndef WALL_TYPES
#define WALL_TYPES

// Binding points in the kernels of cloth and particles.
const int wallClassesBinding = 4;
const int wallFieldUnit = 8;
const int maxWallLevels = 16;

struct WallGrid {
  vec2 corner;       // x and z of sample (0, 0), m
  float spacing;     // Distance between samples, m
  float perSpacing;  // 1 / spacing, in 1/m
  float bottom;      // Height of the bottom in metres
  float roof;        // Top of the rock above a ceiling, m
  float reach;       // Distance kept from the solid, m
  float kept;        // Fraction of the tangential velocity that remains
  float bounce;      // Fraction of the impact speed that remains after the bounce
  int levelCount;
  int ceiling;       // 1 if the solid has a ceiling
  int squares;       // Number of squares, on each side of the square that contains the point, that must be searched for
                     // walls within the distance `reach`
  ivec2 samples;     // Size of the field plus 2
  float heights[maxWallLevels + 1];  // Height of each class, m
  float levels[maxWallLevels];
};

#endif
