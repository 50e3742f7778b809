#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "mesh/height_array.glsl"
#include "cloth/types.glsl"

layout(std140, binding = 0) uniform StepBlock { ClothStep stepData; };
uniform ivec2 size;
