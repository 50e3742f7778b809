#pragma once
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// The uniform block that holds a number for each texture with its sampler, by their names: bit 0 linear;
/// bits 2 and 3, 4 and 5, 6 and 7 what is beyond the ends in x, y, z: 0 repeat, 1 the end's texel, 2
/// mirrored.
inline constexpr const char* samplerBlock = "simreel_Samplers";

/// Reads of textures of two and three dimensions and of layers become calls of our own filter. Cube maps,
/// comparisons, gathers and reads with an offset stay the driver's.
void filterExactly(Module& module);

}  // namespace simreel::kernels
