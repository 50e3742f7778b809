#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// Suffix of the shadow block, which records for each word of a buffer or texel of an image which
/// invocation changed it.
inline constexpr const char* shadowSuffix = ".shadow";
/// Number of shadow words per word of a buffer or texel of an image. They hold the highest invocation
/// (counted from 1) that changed the bits, the complement of the lowest stored value, and the highest
/// stored value.
inline constexpr std::uint32_t shadowWords = 3;

/// Adds code that fills the shadows of all buffers and images that a kernel stores to, except arrays of
/// resources. Must be called after layOut(). `guards` is the number of extra elements after a buffer's end,
/// which receive dropped writes.
void recordWrites(Module& module, bool hlsl, std::uint32_t guards);
/// Adds code that compares each access with the recorded shadows. It reports accesses to words that another
/// invocation changed.
void checkAccesses(Module& module, bool hlsl, std::uint32_t guards, Report& report);

}  // namespace simreel::kernels
