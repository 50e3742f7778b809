#include "golden/files/png_check.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

#include <isa-l/crc.h>

namespace simreel::golden {

namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t frameOfChunk = 12;  // length, type, checksum

std::uint32_t bigEndian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunk {
  std::string_view type;
  std::string_view data;
  std::string_view whole;  ///< with length and checksum
};

/// The chunk at the beginning of `rest`, which is moved past it; nothing when it is cut off.
std::optional<Chunk> takeChunk(std::string_view& rest) {
  if (rest.size() < frameOfChunk) return std::nullopt;
  const std::size_t length = bigEndian(rest.data());
  if (length > rest.size() - frameOfChunk) return std::nullopt;
  const Chunk chunk{rest.substr(4, 4), rest.substr(8, length), rest.substr(0, length + frameOfChunk)};
  rest.remove_prefix(chunk.whole.size());
  return chunk;
}

bool checksumHolds(const Chunk& chunk) {
  const std::string_view covered = chunk.whole.substr(4, chunk.data.size() + 4);
  const auto* bytes = reinterpret_cast<const unsigned char*>(covered.data());
  return crc32_gzip_refl(0, bytes, covered.size()) == bigEndian(chunk.whole.data() + covered.size() + 4);
}

bool isText(const Chunk& chunk) {
  constexpr std::array<std::string_view, 4> types = {"tEXt", "zTXt", "iTXt", "tIME"};
  return std::find(types.begin(), types.end(), chunk.type) != types.end();
}

/// What is wrong with the header's pixel format; empty when nothing is (PNG specification 11.2.2).
std::string formatProblem(std::string_view header) {
  const int depth = static_cast<unsigned char>(header[8]), colour = static_cast<unsigned char>(header[9]);
  if (depth == 16) return "has 16 bits per channel; convert it to 8-bit RGB";
  if (colour == 3) return "has a palette; convert it to 8-bit RGB";
  if (depth != 8)
    return fmt::format("has {} bit{} per channel; convert it to 8-bit RGB", depth, depth == 1 ? "" : "s");
  if (colour != 0 && colour != 2 && colour != 4 && colour != 6)
    return fmt::format("is corrupt (colour type {}); make it again", colour);
  return {};
}

/// What is wrong with the file, to follow its name; empty when nothing is.
std::string problem(std::string_view file) {
  if (file.empty()) return "is empty; make it again";
  // A file that ends inside the signature was a PNG, as far as one can tell.
  if (file.substr(0, signature.size()) != signature.substr(0, std::min(file.size(), signature.size())))
    return "is not a PNG file; convert it to an 8-bit RGB PNG";
  std::string cutOff = fmt::format("is cut off after {} bytes; make it again", file.size());
  if (file.size() < signature.size()) return cutOff;
  std::string_view rest = file.substr(signature.size());
  bool first = true, pixels = false;
  while (!rest.empty()) {
    const std::size_t at = file.size() - rest.size();
    const auto chunk = takeChunk(rest);
    if (!chunk) return cutOff;
    if (!checksumHolds(*chunk))
      return fmt::format("is corrupt (wrong checksum of the chunk at byte {}); make it again", at);
    if (first != (chunk->type == "IHDR") || (first && chunk->data.size() != 13))
      return fmt::format("is corrupt (no header, or two, at byte {}); make it again", at);
    if (first)
      if (auto wrong = formatProblem(chunk->data); !wrong.empty()) return wrong;
    if (chunk->type == "acTL") return "is an animated PNG; compare its frames as separate files";
    first = false;
    pixels = pixels || chunk->type == "IDAT";
    if (chunk->type != "IEND") continue;
    if (!pixels) return "is corrupt (it holds no pixels); make it again";
    if (!rest.empty())
      return fmt::format("is corrupt ({} bytes follow its end); make it again", rest.size());
    return {};
  }
  return cutOff;
}

/// The next chunk that matters to pixels, or nothing at the end.
std::optional<Chunk> nextPixelChunk(std::string_view& rest) {
  auto chunk = takeChunk(rest);
  while (chunk && isText(*chunk)) chunk = takeChunk(rest);
  return chunk;
}

}  // namespace

void checkPng(std::span<const std::byte> file, const char* what, const std::string& name) {
  const std::string wrong = problem(textOf(file));
  if (!wrong.empty()) fail(ExitCode::inputOutput, "{} {} {}", what, name, wrong);
}

void readPngFile(const std::filesystem::path& path, const char* what, std::string& file) {
  const auto failed = [&](const char* verb) {
    fail(ExitCode::inputOutput, "cannot {} {} {}: {}", verb, what, path.string(), std::strerror(errno));
  };
  // Opening a pipe that nobody writes into would wait for ever.
  std::error_code unknown;
  const auto kind = std::filesystem::status(path, unknown).type();
  if (kind == std::filesystem::file_type::fifo || kind == std::filesystem::file_type::character ||
      kind == std::filesystem::file_type::block || kind == std::filesystem::file_type::socket)
    fail(ExitCode::inputOutput, "{} {} is a pipe, a device or a socket; copy what it gives into a file",
         what, path.string());
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rbe"),
                                                               &std::fclose);
  if (!stream) failed("open");
  std::setvbuf(stream.get(), nullptr, _IONBF, 0);  // straight into `file`
  const auto size = std::filesystem::file_size(path, unknown);
  file.resize(unknown ? 65536 : size + 1);
  std::size_t used = 0;
  while (const std::size_t got = std::fread(file.data() + used, 1, file.size() - used, stream.get())) {
    used += got;
    if (used == file.size()) file.resize(2 * used);
  }
  if (std::ferror(stream.get()) != 0) failed("read");
  file.resize(used);
  checkPng(std::as_bytes(std::span(file)), what, path.string());
}

frame::Image readPng(const std::filesystem::path& path, const char* what) {
  std::string file;
  readPngFile(path, what, file);
  return frame::decodeImage(std::as_bytes(std::span(file)), path.string());
}

bool sameEncodedPixels(std::span<const std::byte> a, std::span<const std::byte> b) {
  std::string_view restA = textOf(a), restB = textOf(b);
  if (restA == restB) return true;
  if (!restA.starts_with(signature) || !restB.starts_with(signature)) return false;
  restA.remove_prefix(signature.size());
  restB.remove_prefix(signature.size());
  while (true) {
    const auto chunkA = nextPixelChunk(restA), chunkB = nextPixelChunk(restB);
    if (!chunkA || !chunkB) return !chunkA && !chunkB && restA.empty() && restB.empty();
    if (chunkA->whole != chunkB->whole) return false;
  }
}

}  // namespace simreel::golden
