#pragma once
#include "kernels/guards/report.hpp"

namespace simreel::kernels {

/// End of the name of a block that says which invocations changed the words of a buffer or image.
inline constexpr const char* shadowSuffix = ".shadow";
/// Words of a shadow for each word of a buffer and for each texel of an image: the highest invocation that
/// changed its bits, counted from 1; the complement of the lowest value that was stored; the highest value.
inline constexpr std::uint32_t shadowWords = 3;

/// Adds code after layOut() that writes the shadows of all buffers and images that a kernel stores to,
/// apart from arrays of them.
/// `guards`: elements of a buffer beyond its length, which take dropped writes.
void recordWrites(Module& module, bool hlsl, std::uint32_t guards);
/// Adds code that compares accesses with recorded shadows and notes those of words that another invocation
/// changed.
void checkAccesses(Module& module, bool hlsl, std::uint32_t guards, Report& report);

}  // namespace simreel::kernels
