// Includes and buffers common to all particle kernels except accelerate.comp.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "particles/bindings.glsl"
#include "particles/types.glsl"
#include "particles/pairs.glsl"
#include "particles/pace.glsl"
#include "collide/field_array.glsl"
#include "mesh/height_array.glsl"
#include "contour/wall_array.glsl"
#include "fluid/wind_array.glsl"

layout(std140, binding = stepBinding) uniform StepBlock { ParticleStep stepData; };
layout(local_size_x = 64) in;
#ifndef BALLS
STATE_ARRAY(positionsBinding, PositionBlock, positions)
STATE_ARRAY(velocitiesBinding, VelocityBlock, velocities)
#ifdef ROLLS
STATE_ARRAY(spinsBinding, SpinBlock, spins)
#endif
#ifdef SETTLES
INPUT_ARRAY(startsBinding, StartBlock, starts)
#else
STATE_ARRAY(accelerationsBinding, AccelerationBlock, accelerations)
#endif
#endif
#include "particles/contact/scale.glsl"
#include "particles/model.glsl"
