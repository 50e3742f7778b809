#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel {

inline constexpr std::string_view pngSignature("\x89PNG\r\n\x1a\n", 8);

/// Chunk of a PNG file (ISO/IEC 15948, 5.3). The members refer to the file's bytes.
struct PngChunk {
  static constexpr std::size_t frame = 12;  ///< total bytes of the fields length, type and checksum

  std::string_view type, data;
  std::string_view whole;  ///< all bytes of the chunk, with length, type and checksum

  [[nodiscard]] bool checksumHolds() const;
};

/// Returns the chunk at the start of `rest` and moves `rest` past it. Returns nullopt if the chunk is
/// truncated.
[[nodiscard]] std::optional<PngChunk> takePngChunk(std::string_view& rest);
/// Returns the bytes of all chunks, which follow the signature. Returns nullopt if the file is not a PNG.
[[nodiscard]] std::optional<std::string_view> pngChunks(std::string_view file);

/// Size and pixel format of an image, from the header chunk of a PNG.
struct PngHeader {
  static constexpr std::size_t size = 13;

  std::uint32_t width = 0, height = 0;
  int depth = 0, colour = 0;  ///< bits per channel, and the PNG code of the colour type
  bool plain = false;         ///< true if the image is not interlaced and uses the standard compression and
                              ///< filter methods
};

/// Reads a header. `data`: data of the header chunk, `PngHeader::size` bytes.
[[nodiscard]] PngHeader readPngHeader(std::string_view data);
/// Returns the header of a PNG file without verifying the chunk's checksum. Returns nullopt if the file is
/// not a PNG or is too short.
[[nodiscard]] std::optional<PngHeader> pngHeaderOf(std::string_view file);

/// Appends a chunk to a file in memory.
void appendPngChunk(std::vector<std::byte>& file, std::string_view type, std::string_view data);
/// Appends a 32-bit number in the byte order of PNG (big-endian).
void appendPngNumber(std::string& bytes, std::uint32_t number);

}  // namespace simreel
