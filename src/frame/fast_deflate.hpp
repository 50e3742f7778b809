#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace simreel::frame {

/// Bytes that fastZlib may write for an input of `size` bytes.
[[nodiscard]] std::size_t fastZlibBound(std::size_t size);

/// Compresses into `out` (at least fastZlibBound(in.size()) bytes) as a zlib stream (RFC 1950, 1951);
/// returns the bytes used. Made for filtered picture rows: one probe for a match at each place, of
/// which fewer are tried the longer nothing was found, and one Huffman code a block. libdeflate's level 1
/// needs 5.6 ms for 1280x720 even where every row is the same, which is only 5 times as fast as
/// stock stb; long runs cost next to nothing here (measured by tools/bench/png.cpp).
/// The result depends on nothing but the input. Safe to call from several threads.
[[nodiscard]] std::size_t fastZlib(std::span<const std::uint8_t> in, std::span<std::uint8_t> out);

}  // namespace simreel::frame
