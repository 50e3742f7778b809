// Declarations of a pass over every pixel of a target. The pass is a fragment shader. KERNEL: it is a compute shader
// that stores to an image of the format KERNEL instead. PIXEL is the centre of the pixel; the pass ends with
// PUT(value).
#include "draw/bindings.glsl"
#ifdef KERNEL
layout(local_size_x = 8, local_size_y = 8) in;
layout(KERNEL, binding = targetImage) writeonly restrict uniform image2D target;
#define PIXEL (vec2(gl_GlobalInvocationID.xy) + 0.5)
// stores outside the image have no effect
#define PUT(value) imageStore(target, ivec2(gl_GlobalInvocationID.xy), value)
#else
layout(location = 0) out vec4 result;
#define PIXEL gl_FragCoord.xy
#define PUT(value) result = value
#endif
