#pragma once
#include "kernels/guards/report.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Number of extra elements at the end of a buffer that are hidden from the kernel. The first one is always
/// zero and is read in place of out-of-bounds elements. The second one receives out-of-bounds writes.
inline constexpr std::uint32_t guardElements = 2;

/// Makes every out-of-bounds read return zero and drops every out-of-bounds write, in buffers, arrays in
/// shared and private memory, vectors, and texels. Must run after HLSL functions are inlined. There is one
/// exception: an out-of-bounds read of a whole struct from an array of fixed length returns the last
/// element. OpenGL itself drops out-of-bounds image writes. `report`: records each out-of-bounds access;
/// nullptr to record none.
void keepInside(Module& module, Report* report);

}  // namespace simreel::kernels
