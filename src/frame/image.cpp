#include "frame/image.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>

namespace {

/// Memory that stb asks for, kept by each thread for the next picture: fresh pages for every frame
/// took more than half of the time of an easy one.
class Scratch {
 public:
  void* take(std::size_t size) {
    auto best = free_.end();
    for (auto block = free_.begin(); block != free_.end(); ++block)
      if (block->size() >= size && (best == free_.end() || block->size() < best->size())) best = block;
    if (best == free_.end()) {
      if (free_.size() >= mostKept) free_.erase(free_.begin());
      used_.emplace_back(size);
    } else {
      used_.push_back(std::move(*best));
      free_.erase(best);
    }
    return used_.back().data();
  }
  void giveBack(const void* data) {
    for (auto block = used_.begin(); block != used_.end(); ++block) {
      if (block->data() != data) continue;
      free_.push_back(std::move(*block));
      used_.erase(block);
      return;
    }
  }

 private:
  static constexpr std::size_t mostKept = 4;  // stb holds four at most
  std::vector<std::vector<unsigned char>> free_, used_;
};

thread_local Scratch scratch;

void* takeForStb(std::size_t size) {
  try {
    return scratch.take(size);
  } catch (const std::bad_alloc&) {
    return nullptr;  // stb is C: it hands the failure on
  }
}

void giveBackForStb(const void* data) {
  scratch.giveBack(data);
}

/// What ISA-L works in. Each thread keeps one: it is too large for a stack.
struct Deflater {
  isal_zstream stream;
  // Measured on the images of tools/bench/png.cpp: level 0's fixed Huffman code makes files up to 1.23
  // times stock stb's; 2 gains 1 % over 1 for more memory; 3 and libdeflate's fastest miss 10 times its
  // speed.
  static constexpr std::uint32_t level = 1;
  alignas(64) std::array<std::uint8_t, ISAL_DEF_LVL1_DEFAULT> levelBuffer;
};

/// Bytes at the start of a stream that are stored as they are. Without a history ISA-L (to 2.32 at least)
/// hashes three bytes of a register that still holds the address of its stream, so that the matches it
/// finds are another run's once in some thousands. With a dictionary it does not, and the stored bytes are
/// one.
constexpr std::size_t storedFirst = 32;

/// Most that a zlib stream takes: stored blocks with 5 bytes each, header and checksum, and room for
/// ISA-L's 8-byte stores.
std::size_t zlibBound(std::size_t size) {
  return size + 5 * (size / 65535 + 2) + 64 + ISAL_DEF_MAX_HDR_SIZE;
}

/// One deflate stream without a wrapping, which goes on from `history`; bytes written, or nothing when
/// `out` is too small.
std::optional<std::size_t> deflate(std::span<const unsigned char> history,
                                   std::span<const unsigned char> in, std::span<unsigned char> out) {
  thread_local const auto deflater = std::make_unique<Deflater>();
  // Only read; the C interface has no const.
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

/// The zlib stream of `in` (RFC 1950): a stored block, a deflated rest; `out` holds zlibBound() bytes.
/// Bytes written, or nothing if ISA-L fails.
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

/// stb's hook: the result is given back by stb, nullptr means failure.
unsigned char* compressForStb(const unsigned char* data, int size, int* resultSize, int /*quality*/) {
  if (size < 0) return nullptr;
  const auto length = static_cast<std::size_t>(size);
  const std::size_t bound = zlibBound(length);
  auto* result = static_cast<unsigned char*>(takeForStb(bound));
  if (result == nullptr) return nullptr;
  try {
    const auto written = compressZlib({data, length}, {result, bound});
    if (written && *written <= static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      *resultSize = static_cast<int>(*written);
      return result;
    }
  } catch (const std::bad_alloc&) {  // NOLINT(bugprone-empty-catch): stb hands the failure on.
  }
  giveBackForStb(result);
  return nullptr;
}

unsigned int crcForStb(const unsigned char* data, int size) {
  return crc32_gzip_refl(0, data, static_cast<std::uint64_t>(size));
}

}  // namespace

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS compressForStb
#define STBIW_CRC32 crcForStb
#define STBIW_MALLOC(size) takeForStb(static_cast<std::size_t>(size))
#define STBIW_REALLOC(data, size) nullptr  // stb's own compressor alone would need it
#define STBIW_FREE(data) giveBackForStb(data)
#include <stb/stb_image_write.h>

namespace simreel::frame {

namespace {

/// PNG row filter for every row: 1 is Sub (left), 2 Up, 4 Paeth. Measured by tools/bench/png.cpp: Paeth
/// alone takes longer than all else, None and Sub have the smallest worst file, and Sub is smaller on
/// the average. Set when the program is loaded, so before any thread can read it.
[[maybe_unused]] const int rowFilter = stbi_write_force_png_filter = 1;

constexpr int largestSide = 16384;
constexpr std::size_t signatureAndHeader = 8 + 25;  // the signature, then the whole IHDR chunk

/// RGB of an image, followed by one byte of slack, in a buffer that each thread keeps: fresh pages for
/// every frame cost as much as a tenth of the encoding.
std::span<unsigned char> packRgb(const Image& image) {
  const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
  SIMREEL_CHECK(image.width > 0 && image.height > 0);
  SIMREEL_CHECK_EQ(image.bytes.size(), pixels * 4);
  // Four bytes are copied for each three; the next pixel overwrites the fourth.
  thread_local std::vector<unsigned char> rgb;
  rgb.resize(pixels * 3 + 1);
  const std::uint8_t* from = image.bytes.data();
  unsigned char* to = rgb.data();
  for (std::size_t i = 0; i < pixels; ++i, from += 4, to += 3) std::memcpy(to, from, 4);
  return std::span(rgb).first(pixels * 3);
}

void appendBigEndian(std::string& out, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>((value >> shift) & 0xff);
}

/// Decodes one UTF-8 character from `text` at `i`, moving `i` past it; -1 when it is malformed.
int nextCharacter(std::string_view text, std::size_t& i) {
  const auto lead = static_cast<unsigned char>(text[i++]);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : 1;
  if (lead < 0xc2 || lead > 0xf4) return -1;
  int code = lead & (0x3f >> more);
  for (int k = 0; k < more; ++k, ++i) {
    if (i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return -1;
    code = (code << 6) | (text[i] & 0x3f);
  }
  return code;
}

struct ChunkText {
  std::string latin1;
  std::string utf8;
  bool fitsLatin1 = true;
};

/// Both encodings of a value. Malformed bytes and NUL, which would end the text, become '?'.
ChunkText convertText(std::string_view value) {
  ChunkText result;
  for (std::size_t i = 0; i < value.size();) {
    const std::size_t begin = i;
    const int code = nextCharacter(value, i);
    if (code <= 0) {
      result.latin1 += '?';
      result.utf8 += '?';
      continue;
    }
    result.utf8 += value.substr(begin, i - begin);
    result.latin1 += static_cast<char>(code <= 0xff ? code : '?');
    result.fitsLatin1 = result.fitsLatin1 && code <= 0xff;
  }
  return result;
}

/// tEXt holds Latin-1 only; anything else goes into an uncompressed iTXt (PNG specification 11.3.4).
std::string textChunk(const std::string& keyword, std::string_view value) {
  SIMREEL_CHECK(!keyword.empty() && keyword.size() <= 79);
  const ChunkText text = convertText(value);
  std::string body = text.fitsLatin1 ? "tEXt" : "iTXt";
  body += keyword;
  // After the keyword's NUL, iTXt has: not compressed, method 0, no language, no translated keyword.
  body.append(text.fitsLatin1 ? 1 : 5, '\0');
  body += text.fitsLatin1 ? text.latin1 : text.utf8;
  std::string chunk;
  appendBigEndian(chunk, static_cast<std::uint32_t>(body.size() - 4));
  chunk += body;
  appendBigEndian(chunk,
                  crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(body.data()), body.size()));
  return chunk;
}

}  // namespace

std::vector<std::byte> encodePng(const Image& image, const ImageText& text) {
  SIMREEL_CHECK(image.width <= largestSide && image.height <= largestSide);
  const std::span<unsigned char> rgb = packRgb(image);
  int size = 0;
  const std::unique_ptr<unsigned char, decltype(&giveBackForStb)> png(
      stbi_write_png_to_mem(rgb.data(), image.width * 3, image.width, image.height, 3, &size),
      &giveBackForStb);
  if (!png)
    fail(ExitCode::inputOutput, "cannot encode a {}x{} PNG; is there enough memory?", image.width,
         image.height);

  return withText(std::as_bytes(std::span(png.get(), static_cast<std::size_t>(size))), text);
}

std::vector<std::byte> withText(std::span<const std::byte> png, const ImageText& text) {
  std::string chunks;
  for (const auto& [keyword, value] : text) chunks += textChunk(keyword, value);
  SIMREEL_CHECK(png.size() >= signatureAndHeader);
  std::vector<std::byte> file(png.size() + chunks.size());
  std::memcpy(file.data(), png.data(), signatureAndHeader);
  std::memcpy(file.data() + signatureAndHeader, chunks.data(), chunks.size());
  std::memcpy(file.data() + signatureAndHeader + chunks.size(), png.data() + signatureAndHeader,
              png.size() - signatureAndHeader);
  return file;
}

Image decodeImage(std::span<const std::byte> file, const std::string& name) {
  try {
    sim::Picture picture = sim::decodePicture({reinterpret_cast<const char*>(file.data()), file.size()},
                                              name, "image", largestSide);
    return {picture.size.x, picture.size.y, std::move(picture.rgba)};
  } catch (const UserError& error) {
    throw UserError(ExitCode::inputOutput, error.what());
  }
}

std::string pixelHash(const Image& image) {
  const std::span<const unsigned char> rgb = packRgb(image);
  return hashHex(fmt::format("{}x{} {}", image.width, image.height, hashHex(std::as_bytes(rgb))));
}

}  // namespace simreel::frame
