#include "base/png.hpp"

#include <span>

#include <isa-l/crc.h>

namespace simreel {

namespace {

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// Returns the CRC-32 of a chunk's type and data.
std::uint32_t checksum(std::string_view bytes) {
  return crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

}  // namespace

bool PngChunk::checksumHolds() const {
  return checksum(whole.substr(4, data.size() + 4)) == numberAt(whole, data.size() + 8);
}

std::optional<PngChunk> takePngChunk(std::string_view& rest) {
  if (rest.size() < PngChunk::frame) return std::nullopt;
  const std::size_t length = numberAt(rest, 0);
  if (length > rest.size() - PngChunk::frame) return std::nullopt;
  const PngChunk chunk{rest.substr(4, 4), rest.substr(8, length), rest.substr(0, length + PngChunk::frame)};
  rest.remove_prefix(chunk.whole.size());
  return chunk;
}

std::optional<std::string_view> pngChunks(std::string_view file) {
  if (!file.starts_with(pngSignature)) return std::nullopt;
  return file.substr(pngSignature.size());
}

PngHeader readPngHeader(std::string_view data) {
  return {numberAt(data, 0), numberAt(data, 4), static_cast<unsigned char>(data[8]),
          static_cast<unsigned char>(data[9]), data.ends_with(std::string_view("\0\0\0", 3))};
}

std::optional<PngHeader> pngHeaderOf(std::string_view file) {
  constexpr std::size_t dataAt = 16;
  if (!file.starts_with(pngSignature.substr(0, 4)) || file.size() < dataAt + PngHeader::size)
    return std::nullopt;
  return readPngHeader(file.substr(dataAt, PngHeader::size));
}

void appendPngNumber(std::string& bytes, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(number >> shift & 0xffU);
}

void appendPngChunk(std::vector<std::byte>& file, std::string_view type, std::string_view data) {
  const auto append = [&](std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    file.insert(file.end(), bytes.begin(), bytes.end());
  };
  const auto appendNumber = [&](std::size_t number) {
    std::string bytes;
    appendPngNumber(bytes, static_cast<std::uint32_t>(number));
    append(bytes);
  };
  appendNumber(data.size());
  const std::size_t checked = file.size();
  append(type);
  append(data);
  const std::string_view all(reinterpret_cast<const char*>(file.data()), file.size());
  appendNumber(checksum(all.substr(checked)));
}

}  // namespace simreel
