// Includes and uniforms common to the contact kernels that do not handle solids.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/hash.glsl"
#include "common/memory.glsl"
#include "common/words.glsl"
#include "particles/contact/bindings.glsl"
#include "particles/types.glsl"
layout(std140, binding = stepBinding) uniform StepBlock { ParticleStep stepData; };
layout(local_size_x = 64) in;
#include "particles/ring.glsl"
#include "particles/contact/scale.glsl"
#include "particles/contact/model.glsl"
