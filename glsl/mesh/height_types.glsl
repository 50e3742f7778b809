// The mesh that others fall onto, as its heights are laid out. Compiles as GLSL and as C++
// (src/sim/mesh/height_plan.hpp). Set as plain uniforms, one member at a time.
#ifndef HEIGHT_TYPES
#define HEIGHT_TYPES

const int heightsBinding = 3;  // of the kernels that read them, too

struct HeightGrid {
  vec2 corner;     // x and z of vertex (0, 0) (m)
  vec2 perCell;    // 1/size of a cell along x and z (1/m)
  ivec2 size;      // vertices along x and z
  float progress;  // fraction of the frame that is over at the substep's end
  float perFrame;  // 1/frame (1/s)
  float kept;      // fraction of the tangential velocity
  float bounce;    // fraction of the speed of impact that is given back
  float margin;    // kept above it (m)
};

#endif
