// A pass over every pixel of a target: as a fragment shader, or (KERNEL) as a compute shader that stores to an image of
// the layout KERNEL. PIXEL is the middle of the pixel; finish with PUT(value).
#include "draw/bindings.glsl"
#ifdef KERNEL
layout(local_size_x = 8, local_size_y = 8) in;
layout(KERNEL, binding = targetImage) writeonly restrict uniform image2D target;
#define PIXEL (vec2(gl_GlobalInvocationID.xy) + 0.5)
#define PUT(value) imageStore(target, ivec2(gl_GlobalInvocationID.xy), value)  // beyond the border: nothing
#else
layout(location = 0) out vec4 result;
#define PIXEL gl_FragCoord.xy
#define PUT(value) result = value
#endif
