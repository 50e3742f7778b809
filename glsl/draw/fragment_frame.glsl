// Frame values for fragment shaders. PASSED_FRAME: the values arrive as flat inputs from the vertex shader
// (passed_frame.glsl). llvmpipe reads each number of a uniform block lane by lane, which takes about 25 instructions
// for 8 pixels, while a flat input takes one. Without PASSED_FRAME, the values come from the uniform block.
#include "draw/bindings.glsl"
#ifdef PASSED_FRAME
#define PASSED in
#define PASSED_NAME frame
#include "draw/passed_values.glsl"
#else
#include "draw/frame_block.glsl"
#endif
