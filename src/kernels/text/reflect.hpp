#pragma once
#include "kernels/shader/shader.hpp"
#include "kernels/source/pragmas.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Returns thread groups, buffers, images and blocks of a module after layOut(). writeGlsl() adds the
/// textures, because it combines them with samplers.
[[nodiscard]] Kernel reflected(const Module& module, Language language);

/// Returns the axes along which a module's code asks for the number of its invocation or group, as
/// Kernel::axes. Call before code that reports is added.
[[nodiscard]] unsigned numberedAxes(const Module& module);

/// "2D", "3DArray" and so on, and "float", "int", "uint" of an image's type.
void describeImage(const Module& module, const Instruction& image, Texture& texture);

}  // namespace simreel::kernels
