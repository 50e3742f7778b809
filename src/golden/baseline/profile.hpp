#pragma once
#include <string>

namespace simreel::golden {

/// Short name of the family of drivers and devices that round alike, as far as GL_RENDERER tells; names a
/// folder of baselines. "llvmpipe (LLVM 15.0.6, 256 bits)" with FMA is "llvmpipe-fma", a GeForce RTX 3080
/// "nvidia-ampere", a Radeon RX 6700 XT "amd-navi22". Layers over another driver keep both names
/// ("zink-nvidia-pascal"). At most 32 of [a-z0-9-]; "unknown" where nothing is left.
/// `fma`: whether the processor fuses multiply and add, which llvmpipe's results depend on.
[[nodiscard]] std::string profileName(const std::string& renderer, bool fma);
/// Of this processor; true where it is not known how to ask (every other current architecture has it).
[[nodiscard]] bool processorHasFma();
/// profileName on this processor.
[[nodiscard]] std::string ownProfile(const std::string& renderer);

}  // namespace simreel::golden
