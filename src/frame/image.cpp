#include "frame/image.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/png.hpp"
#include "base/text.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/grid/plain_png.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <isa-l/igzip_lib.h>

namespace simreel::frame {

namespace {

/// State and buffers of the ISA-L compressor. They are too large for the stack, so each thread has one
/// object.
struct Deflater {
  isal_zstream stream;
  // Compression level 1 was chosen by measurements with tools/bench/png.cpp. Level 0 has a fixed Huffman
  // code and makes files up to 1.23 times as large as the files of stb. Level 2 makes files 1 % smaller
  // than level 1 but needs more memory. Level 3 and libdeflate's fastest level do not reach 10 times the
  // speed of stb.
  static constexpr std::uint32_t level = 1;
  alignas(64) std::array<std::uint8_t, ISAL_DEF_LVL1_DEFAULT> levelBuffer;
};

/// Number of bytes at the start of a zlib stream that are stored uncompressed and then serve as a
/// dictionary. Without a dictionary, ISA-L (at least up to 2.32) hashes three bytes of a register that
/// still contains the stream's address, so its output differs about once in some thousand runs. With a
/// dictionary the output is deterministic.
constexpr std::size_t storedFirst = 32;

/// Returns the max size of a zlib stream for `size` bytes: stored blocks (5 bytes each), header, checksum,
/// and space for the 8-byte stores of ISA-L.
std::size_t zlibBound(std::size_t size) {
  return size + 5 * (size / 65535 + 2) + 64 + ISAL_DEF_MAX_HDR_SIZE;
}

/// Writes a raw deflate stream of `in` to `out`, with `history` as preset dictionary. Returns the number of
/// bytes written, or nothing if `out` is too small.
std::optional<std::size_t> deflate(std::span<const unsigned char> history,
                                   std::span<const unsigned char> in, std::span<unsigned char> out) {
  thread_local const auto deflater = std::make_unique<Deflater>();
  // ISA-L does not modify the bytes, but its C interface lacks const.
  const auto writable = [](std::span<const unsigned char> bytes) {
    return const_cast<unsigned char*>(bytes.data());
  };
  isal_zstream& stream = deflater->stream;
  isal_deflate_init(&stream);
  stream.level = Deflater::level;
  stream.level_buf = deflater->levelBuffer.data();
  stream.level_buf_size = static_cast<std::uint32_t>(deflater->levelBuffer.size());
  stream.gzip_flag = IGZIP_DEFLATE;
  stream.end_of_stream = 1;
  if (isal_deflate_set_dict(&stream, writable(history), static_cast<std::uint32_t>(history.size())) !=
      COMP_OK)
    return std::nullopt;
  stream.next_in = writable(in);
  stream.avail_in = static_cast<std::uint32_t>(in.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<std::uint32_t>(out.size());
  if (isal_deflate(&stream) != COMP_OK || stream.internal_state.state != ZSTATE_END) return std::nullopt;
  return stream.total_out;
}

/// Writes the zlib stream of `in` (RFC 1950): one stored block, then one deflated block. `out` holds
/// zlibBound() bytes. Returns the number of bytes written, or nothing if ISA-L fails.
std::optional<std::size_t> compressZlib(std::span<const unsigned char> in, std::span<unsigned char> out) {
  const std::size_t stored = std::min(storedFirst, in.size());
  const bool isAll = stored == in.size();
  const auto count = static_cast<unsigned char>(stored);
  std::size_t size = 0;
  for (const int byte : {0x78, 0x01, isAll ? 1 : 0, int{count}, 0, count ^ 0xff, 0xff})
    out[size++] = static_cast<unsigned char>(byte);
  std::copy_n(in.begin(), stored, out.begin() + static_cast<std::ptrdiff_t>(size));
  size += stored;
  if (!isAll) {
    constexpr std::size_t checksum = 4;
    const auto deflated =
        deflate(in.first(stored), in.subspan(stored), out.subspan(size, out.size() - size - checksum));
    if (!deflated) return std::nullopt;
    size += *deflated;
  }
  const std::uint32_t check = isal_adler32(1, in.data(), in.size());
  for (const int shift : {24, 16, 8, 0}) out[size++] = static_cast<unsigned char>((check >> shift) & 0xff);
  return size;
}

/// max width or height if the size is not known from the file header
constexpr int largestSide = 16384;
/// max width or height of any decoder; larger images are rejected before decoding
constexpr int largestSideOfAll = 1 << 24;
constexpr std::size_t maxPixels = std::size_t{1} << 28;

using Bytes = std::span<const unsigned char>;

/// True if every alpha value is 255.
bool isOpaque(const Image& image) {
  for (std::size_t i = 3; i < image.bytes.size(); i += 4)
    if (image.bytes[i] != 255) return false;
  return true;
}

PackedPixels pixelsOf(const Image& image, Bytes bytes) {
  return {{image.width, image.height}, image.alpha ? 4 : 3, 8, bytes};
}

/// Returns the RGB bytes of an image, or its RGBA bytes if `withAlpha` is true. The RGB buffer is
/// thread-local, because allocating new pages for every frame takes up to a tenth of the encoding time. The
/// result is valid until the thread's next call.
Bytes packed(const Image& image, bool withAlpha) {
  const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
  SIMREEL_CHECK(image.width > 0 && image.height > 0);
  SIMREEL_CHECK_EQ(image.bytes.size(), pixels * 4);
  if (withAlpha) return image.bytes;
  // memcpy copies 4 bytes for each 3-byte pixel. The next pixel overwrites the fourth byte.
  thread_local std::vector<unsigned char> rgb;
  rgb.resize(pixels * 3 + 1);
  const std::uint8_t* from = image.bytes.data();
  unsigned char* to = rgb.data();
  for (std::size_t i = 0; i < pixels; ++i, from += 4, to += 3) std::memcpy(to, from, 4);
  return Bytes(rgb).first(pixels * 3);
}

/// Returns the rows as PNG stores them. Each row starts with its filter type, Sub (difference from the
/// pixel on the left). The filter was chosen by measurements with tools/bench/png.cpp. Paeth alone takes
/// longer than the other encoding steps together. None and Sub have the smallest worst-case file, and Sub
/// has smaller files on average. The buffer is thread-local, as in packed().
Bytes filterRows(Bytes rgb, std::size_t stride, std::size_t pixel) {
  constexpr unsigned char sub = 1;
  thread_local std::vector<unsigned char> rows;
  const std::size_t height = rgb.size() / stride;
  rows.resize(height * (stride + 1));
  unsigned char* to = rows.data();
  for (std::size_t y = 0; y < height; ++y) {
    const unsigned char* from = rgb.data() + y * stride;
    *to++ = sub;
    for (std::size_t i = 0; i < pixel; ++i) to[i] = from[i];
    for (std::size_t i = pixel; i < stride; ++i)
      to[i] = static_cast<unsigned char>(from[i] - from[i - pixel]);
    to += stride;
  }
  return rows;
}

using File = std::vector<std::byte>;

struct ChunkText {
  std::string latin1;
  std::string utf8;
  bool fitsLatin1 = true;
};

/// Converts a UTF-8 value to Latin-1 and to clean UTF-8. Replaces malformed bytes and NUL (the terminator)
/// by '?'.
ChunkText convertText(std::string_view value) {
  ChunkText result;
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t length = codePointLength(value, i);
    const std::string_view character = value.substr(i, std::max<std::size_t>(length, 1));
    const char32_t code = length > 0 ? codePoint(character) : U'\0';
    i += character.size();
    result.utf8 += code == 0 ? "?" : character;
    result.latin1 += code == 0 || code > 0xff ? '?' : static_cast<char>(code);
    result.fitsLatin1 = result.fitsLatin1 && code <= 0xff;
  }
  return result;
}

/// Appends the colour space chunks: sRGB with perceptual intent and, for decoders that ignore it, the
/// nearest gamma and primaries (PNG specification 11.3.3.5). Linear pictures get a gamma of 1 and no sRGB
/// chunk.
void appendColorSpace(File& file, bool linear) {
  const auto words = [](std::initializer_list<std::uint32_t> values) {
    std::string bytes;
    for (const std::uint32_t value : values) appendPngNumber(bytes, value);
    return bytes;
  };
  if (!linear) appendPngChunk(file, "sRGB", std::string_view("\0", 1));
  appendPngChunk(file, "gAMA", words({linear ? 100000U : 45455U}));
  appendPngChunk(file, "cHRM", words({31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000}));
}

/// Appends a text chunk: tEXt if Latin-1 can represent the value, otherwise an uncompressed iTXt (PNG
/// specification 11.3.4).
void appendText(File& file, const std::string& keyword, std::string_view value) {
  SIMREEL_CHECK(!keyword.empty() && keyword.size() <= 79);
  const ChunkText text = convertText(value);
  // The bytes after the keyword's NUL in iTXt mean: uncompressed, method 0, empty language, empty
  // translated keyword.
  appendPngChunk(
      file, text.fitsLatin1 ? "tEXt" : "iTXt",
      keyword + std::string(text.fitsLatin1 ? 1 : 5, '\0') + (text.fitsLatin1 ? text.latin1 : text.utf8));
}

/// Returns the pixel hash of `image`. `bytes`: packed pixels of the image. An image whose alpha is 255
/// everywhere has the same hash as the image without alpha.
std::string hashOf(const Image& image, Bytes bytes) {
  const bool withAlpha = image.alpha && !isOpaque(image);
  if (image.alpha && !withAlpha) bytes = packed(image, false);
  return hashHex(fmt::format("{}x{} {}{}", image.width, image.height, withAlpha ? "alpha " : "",
                             hashHex(std::as_bytes(bytes))));
}

File encode(const PackedPixels& pixels, const ImageText& text) {
  SIMREEL_CHECK(pixels.size.x <= largestSide && pixels.size.y <= largestSide);
  std::string header;
  for (const int side : {pixels.size.x, pixels.size.y})
    appendPngNumber(header, static_cast<std::uint32_t>(side));
  constexpr char colourTypes[] = {0, 0, 0, 2, 6};  // colour type by number of channels (1 grey, 3 RGB, 4
                                                   // RGBA)
  // The last three header bytes mean: deflate, filters per row, not interlaced.
  header += {static_cast<char>(pixels.bits), colourTypes[pixels.channels], 0, 0, 0};

  const auto pixel = static_cast<std::size_t>(pixels.channels * pixels.bits / 8);
  const Bytes rows = filterRows(pixels.bytes, std::size_t(pixels.size.x) * pixel, pixel);
  thread_local std::vector<unsigned char> compressed;
  compressed.resize(zlibBound(rows.size()));
  const auto size = compressZlib(rows, compressed);
  if (!size)
    fail(ExitCode::inputOutput, "cannot encode a {}x{} PNG; is there enough memory?", pixels.size.x,
         pixels.size.y);

  File texts;
  appendColorSpace(texts, pixels.linear);
  for (const auto& [keyword, value] : text) appendText(texts, keyword, value);
  File file;
  file.reserve(pngSignature.size() + PngHeader::size + texts.size() + *size + 3 * PngChunk::frame);
  const auto signature = std::as_bytes(std::span(pngSignature));
  file.assign(signature.begin(), signature.end());
  appendPngChunk(file, "IHDR", header);
  file.insert(file.end(), texts.begin(), texts.end());
  appendPngChunk(file, "IDAT", {reinterpret_cast<const char*>(compressed.data()), *size});
  appendPngChunk(file, "IEND", {});
  return file;
}

}  // namespace

std::vector<std::byte> encodePng(const Image& image, const ImageText& text) {
  return encode(pixelsOf(image, packed(image, image.alpha)), text);
}

std::vector<std::byte> encodePng(const PackedPixels& pixels, const ImageText& text) {
  return encode(pixels, text);
}

HashedFile encodeHashedPng(const Image& image, const ImageText& text) {
  const Bytes bytes = packed(image, image.alpha);
  return {encode(pixelsOf(image, bytes), text), hashOf(image, bytes)};
}

namespace {

/// Returns width and height of a JPEG, read from its first frame header (ITU-T T.81, B.2.2).
std::optional<glm::ivec2> sizeOfJpeg(std::string_view bytes) {
  const auto two = [&](std::size_t at) {
    return static_cast<unsigned char>(bytes[at]) << 8 | static_cast<unsigned char>(bytes[at + 1]);
  };
  for (std::size_t at = 2; at + 9 <= bytes.size() && bytes[at] == '\xff';) {
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const bool other = marker == 0xc4 || marker == 0xc8 || marker == 0xcc;
    if (marker >= 0xc0 && marker <= 0xcf && !other) return glm::ivec2(two(at + 7), two(at + 5));
    at += 2 + static_cast<std::size_t>(two(at + 2));
  }
  return std::nullopt;
}

/// Returns width and height from a PNG or JPEG header. Returns nothing for other formats.
std::optional<glm::ivec2> sizeInHeader(std::string_view bytes) {
  if (bytes.starts_with("\xff\xd8")) return sizeOfJpeg(bytes);
  const auto header = pngHeaderOf(bytes);
  if (!header || std::max(header->width, header->height) > static_cast<std::uint32_t>(largestSideOfAll))
    return std::nullopt;
  return glm::ivec2(header->width, header->height);
}

}  // namespace

Image decodeImage(std::span<const std::byte> file, const std::string& name) {
  const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
  const auto size = sizeInHeader(bytes);
  if (size && static_cast<double>(size->x) * size->y > static_cast<double>(maxPixels))
    fail(ExitCode::inputOutput, "the image {} is {}x{}, more than {} million pixels", name, size->x,
         size->y, maxPixels / 1'000'000);
  try {
    auto picture = sim::decodePlainPng(bytes, largestSideOfAll);
    if (!picture) picture = sim::decodePicture(bytes, name, "image", size ? largestSideOfAll : largestSide);
    Image image{picture->size.x, picture->size.y, std::move(picture->rgba)};
    image.alpha = !isOpaque(image);
    return image;
  } catch (const UserError& error) {
    throw UserError(ExitCode::inputOutput, error.what());
  }
}

std::string pixelHash(const Image& image) {
  return hashOf(image, packed(image, image.alpha));
}

}  // namespace simreel::frame
