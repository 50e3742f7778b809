#pragma once
#include "kernels/shader/shader.hpp"
#include "kernels/source/pragmas.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Returns thread groups, buffers, images and blocks of a module after layOut(). writeGlsl() adds the
/// textures, because it combines them with samplers.
[[nodiscard]] Kernel reflected(const Module& module, Language language);

/// Sets the type ("2D", "3DArray", ...) and the component type ("float", "int", "uint") of an image.
void describeImage(const Module& module, const Instruction& image, Texture& texture);

}  // namespace simreel::kernels
