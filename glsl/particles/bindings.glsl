#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "particles/types.glsl"
#include "particles/pairs.glsl"
#include "particles/pace.glsl"
#include "mesh/height_array.glsl"

layout(std140, binding = 0) uniform StepBlock { ParticleStep stepData; };
layout(local_size_x = 64) in;
STATE_ARRAY(0, PositionBlock, positions)
STATE_ARRAY(1, VelocityBlock, velocities)
STATE_ARRAY(2, AccelerationBlock, accelerations)
#include "particles/model.glsl"
