#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// Suffix of the shadow block that records which invocations changed each word of a buffer or texel of an
/// image.
inline constexpr const char* shadowSuffix = ".shadow";
/// Number of shadow words per word of a buffer or texel of an image: the highest invocation (counted from
/// 1) that changed its bits; the complement of the lowest stored value; the highest stored value.
inline constexpr std::uint32_t shadowWords = 3;

/// Adds code that fills the shadows of all buffers and images that a kernel stores to, except arrays of
/// resources. Call after layOut().
/// `guards`: number of extra elements behind a buffer's length, which absorb dropped writes.
void recordWrites(Module& module, bool hlsl, std::uint32_t guards);
/// Adds code that compares accesses with the recorded shadows and reports accesses to words that another
/// invocation changed.
void checkAccesses(Module& module, bool hlsl, std::uint32_t guards, Report& report);

}  // namespace simreel::kernels
