#pragma once
#include "kernels/spirv/module.hpp"

#include <set>

namespace simreel::kernels {

/// Uniform block with one word for each pair of texture and sampler. The word's name consists of both
/// names. Bit 0 means linear filtering. Bits 2-3, 4-5 and 6-7 hold the wrap mode in x, y and z (0 repeat, 1
/// clamp, 2 mirror).
inline constexpr const char* samplerBlock = "simreel_Samplers";

/// Replaces reads of 2-D, 3-D and array textures by calls of the library's filter. `cubes`: array textures
/// that replace cube maps and are read by a direction. `only`: true to replace only reads of `cubes`. The
/// driver still performs depth comparisons, gathers and reads with an offset.
/// `careful`: as in Request.
void filterExactly(Module& module, const std::set<Id>& cubes, bool only, bool careful);

}  // namespace simreel::kernels
