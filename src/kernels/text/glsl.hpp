#pragma once
#include "kernels/shader/shader.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Writes a module as GLSL 4.5 (SPIRV-Cross), into `kernel` with the textures that it reads: each texture
/// with each of its samplers is one in GLSL. Throws std::runtime_error for what GLSL cannot say.
void writeGlsl(const Module& module, Kernel& kernel);

}  // namespace simreel::kernels
