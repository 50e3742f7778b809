// The mesh that others fall onto, as its heights are laid out. Compiles as GLSL and as C++
// (src/sim/mesh/height_plan.hpp). Set as plain uniforms, one member at a time.
#ifndef HEIGHT_TYPES
#define HEIGHT_TYPES

struct HeightGrid {
  vec4 place;    // xy: x and z of vertex (0, 0) (m); zw: 1/size of a cell along x and z (1/m)
  vec4 moment;   // x part of the frame over at the substep's end; y 1/frame (1/s); z share of tangential velocity
                 // kept; w share of the speed of impact that is given back
  ivec2 size;    // vertices along x and z
  float margin;  // kept above it (m)
};

#endif
