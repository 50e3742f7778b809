// Includes and uniforms common to the garment kernels (cloth made of triangles). HEIGHTS and WALLS are 1 in the kernel
// that tests contact with meshes and solids.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "collide/field_array.glsl"
#include "mesh/height_array.glsl"
#include "contour/wall_array.glsl"
#include "fluid/wind_array.glsl"
#include "garment/bindings.glsl"
#include "cloth/types.glsl"

layout(std140, binding = stepBinding) uniform StepBlock { ClothStep stepData; };
uniform int count;  // Number of invocations
#ifndef KEEPS
#define KEEPS 0
#endif
const bool keeps = KEEPS == 1;  // True if the cloth conserves energy (cloth/keeping.glsl).
