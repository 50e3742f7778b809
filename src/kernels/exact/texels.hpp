#pragma once
#include "kernels/guards/report.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Makes every out-of-bounds texel read of a texture or image return zero. OpenGL drops out-of-bounds
/// writes. Does not change accesses to cube maps and multisampled images. `report`: records out-of-bounds
/// reads and writes, separately for each axis; nullptr to record none.
void keepTexelsInside(Module& module, Report* report);

}  // namespace simreel::kernels
