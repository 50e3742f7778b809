#pragma once
#include <string>

namespace simreel::golden {

/// Returns a short name for the family of drivers and devices that round alike, derived from GL_RENDERER.
/// The name is used for a folder of baselines. For example, "llvmpipe (LLVM 15.0.6, 256 bits)" with FMA
/// gives "llvmpipe-fma", a GeForce RTX 3080 gives "nvidia-ampere", and a Radeon RX 6700 XT gives
/// "amd-navi22". Layered drivers keep both names ("zink-nvidia-pascal"). The name has at most 32 characters
/// of [a-z0-9-]. It is "unknown" if no such characters remain. `fma`: true if the processor has fused
/// multiply-add, which changes llvmpipe's results.
[[nodiscard]] std::string profileName(const std::string& renderer, bool fma);
/// True if this processor has fused multiply-add. Returns true on architectures without a check, because
/// all other current architectures have it.
[[nodiscard]] bool processorHasFma();
/// Returns profileName() for this processor.
[[nodiscard]] std::string ownProfile(const std::string& renderer);

}  // namespace simreel::golden
