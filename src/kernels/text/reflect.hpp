#pragma once
#include "kernels/shader/shader.hpp"
#include "kernels/source/pragmas.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Returns the workgroup size, buffers, images and blocks of a module after layOut(). The result has no
/// textures. writeGlsl() adds them, because it combines textures with samplers.
[[nodiscard]] Kernel reflected(const Module& module, Language language);

/// Returns the axes along which a module reads the index of its invocation or workgroup, as in
/// Kernel::axes. Must be called before report code is added.
[[nodiscard]] unsigned axesRead(const Module& module);

/// Sets the type of `texture` from an image's type: "2D", "3DArray" and so on, and the component type
/// "float", "int" or "uint".
void describeImage(const Module& module, const Instruction& image, Texture& texture);

}  // namespace simreel::kernels
