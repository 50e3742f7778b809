// Includes and uniforms common to all cloth kernels.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "collide/field_array.glsl"
#include "mesh/height_array.glsl"
#include "contour/wall_array.glsl"
#include "fluid/wind_array.glsl"
#include "cloth/bindings.glsl"
#include "cloth/types.glsl"

layout(std140, binding = stepBinding) uniform StepBlock { ClothStep stepData; };
uniform ivec2 size;
#ifndef KEEPS
#define KEEPS 0
#endif
const bool keeps = KEEPS == 1;  // True if the cloth conserves energy (cloth/keeping.glsl).
