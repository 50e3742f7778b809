#pragma once
#include "kernels/guards/report.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// How many elements a buffer has beyond those that its kernel knows: the first is zero for ever and is
/// read in place of what lies outside, the second takes what is written there.
inline constexpr std::uint32_t guardElements = 2;

/// Makes every read outside of an array give zero and drops every write there, after functions of HLSL are
/// inlined: of buffers, arrays in shared and private memory, vectors, and texels. (A struct that is read as
/// a whole from an array of fixed length is the last one instead.) Writes to images outside are left to
/// OpenGL, which drops them. `report`: notes each such read and write; nullptr for none.
void keepInside(Module& module, Report* report);

}  // namespace simreel::kernels
