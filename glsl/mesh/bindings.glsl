#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "mesh/types.glsl"

layout(std140, binding = 0) uniform DeformBlock { DeformStep deformStep; };
