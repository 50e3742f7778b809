#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel {

inline constexpr std::string_view pngSignature("\x89PNG\r\n\x1a\n", 8);

/// A chunk of a PNG file (ISO/IEC 15948, 5.3), in the file's bytes.
struct PngChunk {
  static constexpr std::size_t frame = 12;  ///< bytes of length, type and checksum

  std::string_view type, data;
  std::string_view whole;  ///< with length and checksum

  [[nodiscard]] bool checksumHolds() const;
};

/// The chunk at the start of `rest`, which moves past it; nothing where it is cut off.
[[nodiscard]] std::optional<PngChunk> takePngChunk(std::string_view& rest);
/// The chunks' bytes of a file that begins as a PNG; nothing of another.
[[nodiscard]] std::optional<std::string_view> pngChunks(std::string_view file);

/// Pixel format, from the first chunk.
struct PngHeader {
  static constexpr std::size_t size = 13;

  std::uint32_t width = 0, height = 0;
  int depth = 0, colour = 0;  ///< bits a channel, colour type
  bool plain = false;         ///< whether it is not interlaced, and of the one compression and filter
};

/// `data`: a header's, `PngHeader::size` bytes.
[[nodiscard]] PngHeader readPngHeader(std::string_view data);
/// The header of a file that begins as a PNG, unchecked; nothing of another or of one that ends before.
[[nodiscard]] std::optional<PngHeader> pngHeaderOf(std::string_view file);

/// Adds a chunk to a file.
void appendPngChunk(std::vector<std::byte>& file, std::string_view type, std::string_view data);
/// Adds numbers as PNG has them: 32 bits each, the highest first.
void appendPngNumber(std::string& bytes, std::uint32_t number);

}  // namespace simreel
