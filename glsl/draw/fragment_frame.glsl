// The frame's values for fragment shaders. PASSED_FRAME: as inputs from the vertex shader (passed_frame.glsl), since
// llvmpipe collects each number of a uniform block lane by lane, some 25 instructions for 8 pixels, where an input that
// does not vary takes one.
#include "draw/bindings.glsl"
#ifdef PASSED_FRAME
#define PASSED in
#define PASSED_NAME frame
#include "draw/passed_values.glsl"
#else
#include "draw/frame_block.glsl"
#endif
