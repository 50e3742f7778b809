#pragma once
#include "kernels/guards/report.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Makes every read of a texel beyond its picture give zero, of textures and of images. OpenGL drops writes
/// there. Cube maps and pictures of several samples stay as they are. `report`: notes reads and writes
/// beyond, each axis by itself; nullptr for none.
void keepTexelsInside(Module& module, Report* report);

}  // namespace simreel::kernels
