#pragma once
#include "kernels/shader/shader.hpp"
#include "kernels/spirv/module.hpp"

namespace simreel::kernels {

/// Converts a module to GLSL 4.5 with SPIRV-Cross. Stores the text and the textures in `kernel`. Each
/// combination of a texture and a sampler becomes one GLSL sampler. Throws std::runtime_error for code that
/// GLSL cannot express. `exact` must be true if the module calls exact functions.
void writeGlsl(const Module& module, Kernel& kernel, bool exact);

}  // namespace simreel::kernels
