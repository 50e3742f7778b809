#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// Suffix of the name of a shadow block. For each word of a buffer or texel of an image, the shadow block
/// records which invocation changed it.
inline constexpr const char* shadowSuffix = ".shadow";
/// Number of shadow words per word of a buffer or texel of an image. The shadow words hold the index of the
/// highest invocation (counted from 1) that changed the bits, the complement of the lowest stored value,
/// and the highest stored value.
inline constexpr std::uint32_t shadowWords = 3;

/// Adds code that fills the shadows of all buffers and images that a kernel stores to, except arrays of
/// resources. Must be called after layOut(). `guards` is the number of extra elements after a buffer's end,
/// which receive dropped writes.
void recordWrites(Module& module, bool hlsl, std::uint32_t guards);
/// Adds code that compares each access with the recorded shadows. It reports accesses to words that another
/// invocation changed.
void checkAccesses(Module& module, bool hlsl, std::uint32_t guards, Report& report);

}  // namespace simreel::kernels
