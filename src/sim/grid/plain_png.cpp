// This file follows the PNG specification (ISO/IEC 15948), sections 5 (chunks), 9 (filtering) and 10
// (compression).
#include "sim/grid/plain_png.hpp"

#include "base/png.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

#include <isa-l/igzip_lib.h>

namespace simreel::sim {

namespace {

using Byte = std::uint8_t;

struct Header {
  std::size_t width = 0, height = 0, channels = 0;
};

std::optional<Header> plainHeader(std::string_view data, int maxSide) {
  if (data.size() != PngHeader::size) return std::nullopt;
  const PngHeader header = readPngHeader(data);
  const auto largest = static_cast<std::uint32_t>(maxSide);
  if (header.width < 1 || header.height < 1 || header.width > largest || header.height > largest)
    return std::nullopt;
  const bool rgb = header.colour == 2, rgba = header.colour == 6;
  if (!header.plain || header.depth != 8 || !(rgb || rgba)) return std::nullopt;
  return Header{header.width, header.height, rgba ? std::size_t{4} : std::size_t{3}};
}

struct PlainFile {
  Header header;
  std::vector<std::string_view> pixels;  ///< Contents of the IDAT chunks.
};

/// Reads the chunks; returns nothing if the file contains a critical chunk that is not supported here.
/// Checksums are not verified.
std::optional<PlainFile> readChunks(std::string_view bytes, int maxSide) {
  auto rest = pngChunks(bytes);
  if (!rest) return std::nullopt;
  std::optional<PlainFile> file;
  while (const auto chunk = takePngChunk(*rest)) {
    if (chunk->type == "IHDR") {
      const auto header = plainHeader(chunk->data, maxSide);
      if (file || !header) return std::nullopt;
      file = PlainFile{*header, {}};
      continue;
    }
    const bool ancillary = (static_cast<Byte>(chunk->type[0]) & 0x20) != 0;
    if (!file || chunk->type == "tRNS") return std::nullopt;
    if (chunk->type == "IDAT")
      file->pixels.push_back(chunk->data);
    else if (chunk->type == "IEND")
      return file->pixels.empty() ? std::nullopt : file;
    else if (!ancillary)
      return std::nullopt;
  }
  return std::nullopt;
}

/// Inflates the chunks. Returns true if the result has exactly the size of `rows`.
bool inflate(const std::vector<std::string_view>& chunks, std::vector<Byte>& rows) {
  if (rows.size() > std::numeric_limits<std::uint32_t>::max()) return false;
  const auto kept = std::make_unique<inflate_state>();  // The state is on the heap, because it is too large
                                                        // for the stack.
  inflate_state& state = *kept;
  isal_inflate_init(&state);
  state.crc_flag = ISAL_ZLIB;
  state.next_out = rows.data();
  state.avail_out = static_cast<std::uint32_t>(rows.size());
  for (const std::string_view chunk : chunks) {
    // The const_cast is safe, because ISA-L does not write through next_in.
    state.next_in = const_cast<Byte*>(reinterpret_cast<const Byte*>(chunk.data()));
    state.avail_in = static_cast<std::uint32_t>(chunk.size());
    if (isal_inflate(&state) != ISAL_DECOMP_OK || state.avail_in != 0) return false;
  }
  return state.block_state == ISAL_BLOCK_FINISH && state.avail_out == 0;
}

Byte paeth(int left, int above, int corner) {
  const int toLeft = std::abs(above - corner), toAbove = std::abs(left - corner);
  const int toCorner = std::abs(left + above - 2 * corner);
  const int other = toAbove <= toCorner ? above : corner;
  return static_cast<Byte>(toLeft <= std::min(toAbove, toCorner) ? left : other);
}

/// Adds `predicted(left, above, corner)` to each byte of a row, where the arguments are the bytes of the
/// neighbouring pixels. `left` and `corner` are 0 for the first pixel.
template <std::size_t channels, class Predicted>
void addTo(Byte* row, const Byte* above, std::size_t size, const Predicted& predicted) {
  Byte left[channels] = {}, corner[channels] = {};
  for (std::size_t x = 0; x < size; x += channels)
    for (std::size_t c = 0; c < channels; ++c) {
      const Byte up = above[x + c];
      left[c] = static_cast<Byte>(row[x + c] + predicted(left[c], up, corner[c]));
      corner[c] = up;
      row[x + c] = left[c];
    }
}

template <std::size_t channels>
bool unfilter(int filter, Byte* row, const Byte* above, std::size_t size) {
  switch (filter) {
    case 0:
      return true;
    case 1:
      addTo<channels>(row, above, size, [](int left, int, int) { return left; });
      return true;
    case 2:
      for (std::size_t x = 0; x < size; ++x) row[x] = static_cast<Byte>(row[x] + above[x]);
      return true;
    case 3:
      addTo<channels>(row, above, size, [](int left, int up, int) { return (left + up) / 2; });
      return true;
    case 4:
      addTo<channels>(row, above, size, paeth);
      return true;
    default:
      return false;
  }
}

/// Reverses the row filters and writes RGBA pixels. Returns false for an unknown filter. `rows` holds for
/// each row its filter byte followed by its data.
template <std::size_t channels>
bool makePixels(const Header& header, std::vector<Byte>& rows, std::vector<Byte>& rgba) {
  const std::size_t size = header.width * channels;
  const std::vector<Byte> nothing(size);
  const Byte* above = nothing.data();
  Byte* out = rgba.data();
  for (std::size_t y = 0; y < header.height; ++y) {
    Byte* row = rows.data() + y * (size + 1) + 1;
    if (!unfilter<channels>(row[-1], row, above, size)) return false;
    above = row;
    if constexpr (channels == 4)
      out = std::copy_n(row, size, out);
    else
      for (std::size_t x = 0; x < header.width; ++x, out += 4) {
        for (std::size_t c = 0; c < channels; ++c) out[c] = row[channels * x + c];
        out[3] = 255;
      }
  }
  return true;
}

}  // namespace

std::optional<Picture> decodePlainPng(std::string_view bytes, int maxSide) {
  const auto file = readChunks(bytes, maxSide);
  if (!file) return std::nullopt;
  const Header& header = file->header;
  const std::size_t size = header.height * (header.width * header.channels + 1);
  // Deflate expands one byte to at most 1032 bytes. This check keeps a small file from allocating excessive
  // memory.
  if (size > bytes.size() * 1032) return std::nullopt;
  std::vector<Byte> rows(size);
  if (!inflate(file->pixels, rows)) return std::nullopt;
  Picture picture{{header.width, header.height}, std::vector<Byte>(header.width * header.height * 4)};
  const bool made = header.channels == 3 ? makePixels<3>(header, rows, picture.rgba)
                                         : makePixels<4>(header, rows, picture.rgba);
  return made ? std::optional(std::move(picture)) : std::nullopt;
}

}  // namespace simreel::sim
