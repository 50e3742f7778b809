#pragma once
#include "sim/core/shader_code.hpp"

#define FUNCTION inline
#define precise
namespace simreel::shader::reaction {
#include "glsl/reaction/bindings.glsl"
#include "glsl/reaction/functions.glsl"
#include "glsl/reaction/sampling.glsl"
}  // namespace simreel::shader::reaction
#undef precise
#undef FUNCTION

namespace simreel::sim {

/// Constants for grained() in glsl/reaction/functions.glsl: storedGrain rounds to multiples of 2^-60,
/// flushedGrain to multiples of 2^-96.
inline constexpr float storedGrain = 0x1.8p-37F, flushedGrain = 0x1.8p-73F;

}  // namespace simreel::sim
