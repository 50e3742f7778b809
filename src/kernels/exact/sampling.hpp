#pragma once
#include "kernels/spirv/module.hpp"

#include <set>

namespace simreel::kernels {

/// Uniform block with one word for each pair of texture and sampler, named after both. Bit 0: linear
/// filter. Bits 2-3, 4-5 and 6-7: wrap mode in x, y and z (0 repeat, 1 clamp, 2 mirror).
inline constexpr const char* samplerBlock = "simreel_Samplers";

/// Replaces reads of 2-D, 3-D and array textures by calls of the library's filter. `cubes` holds the array
/// textures that replace cube maps; these are read by a direction. If `only` is true, only reads of `cubes`
/// are replaced. The driver still performs depth comparisons, gathers and reads with an offset.
void filterExactly(Module& module, const std::set<Id>& cubes, bool only, bool careful);

}  // namespace simreel::kernels
