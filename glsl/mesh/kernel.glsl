#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "mesh/bindings.glsl"
#include "mesh/types.glsl"

layout(std140, binding = stepBinding) uniform DeformBlock { DeformStep deformStep; };
