#include "golden/files/png_check.hpp"

#include "base/error.hpp"
#include "base/png.hpp"
#include "golden/files/damage.hpp"
#include "golden/files/picture.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace simreel::golden {

namespace {

std::string_view textOf(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool isText(const PngChunk& chunk) {
  constexpr std::array<std::string_view, 4> types = {"tEXt", "zTXt", "iTXt", "tIME"};
  return std::find(types.begin(), types.end(), chunk.type) != types.end();
}

/// Returns a description of the mistake in the header's pixel format (PNG specification 11.2.2), or an
/// empty text.
std::string formatProblem(std::string_view header) {
  const auto [width, height, depth, colour, plain] = readPngHeader(header);
  constexpr std::array<std::uint32_t, 7> depths = {
      1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16};
  const bool known = colour < static_cast<int>(depths.size()) && (depth & (depth - 1)) == 0 &&
                     (depths[static_cast<std::size_t>(colour)] & static_cast<unsigned>(depth)) != 0;
  if (known) return {};
  return fmt::format("is corrupt (colour type {} of {} bits); {}", colour, depth, restoreIt);
}

/// Returns a description of what is wrong with the file, to follow the file name, or an empty text.
std::string problem(std::string_view file) {
  if (std::string other = placeholderProblem(file); !other.empty()) return other;
  if (file.empty()) return fmt::format("is empty; {}", restoreIt);
  // A file that ends within the signature is treated as a truncated PNG.
  if (file.substr(0, pngSignature.size()) !=
      pngSignature.substr(0, std::min(file.size(), pngSignature.size())))
    return "is not a PNG file; convert it to PNG";
  std::string cutOff = fmt::format("is cut off after {} bytes; {}", file.size(), restoreIt);
  if (file.size() < pngSignature.size()) return cutOff;
  std::string_view rest = file.substr(pngSignature.size());
  bool first = true, pixels = false;
  while (!rest.empty()) {
    const std::size_t at = file.size() - rest.size();
    const auto chunk = takePngChunk(rest);
    if (!chunk) return cutOff;
    if (!chunk->checksumHolds())
      return fmt::format("is corrupt (wrong checksum of the chunk at byte {}); {}", at, restoreIt);
    if (first != (chunk->type == "IHDR") || (first && chunk->data.size() != PngHeader::size))
      return fmt::format("is corrupt (no header, or two, at byte {}); {}", at, restoreIt);
    if (first)
      if (auto wrong = formatProblem(chunk->data); !wrong.empty()) return wrong;
    if (chunk->type == "acTL") return "is an animated PNG; compare its frames as separate files";
    first = false;
    pixels = pixels || chunk->type == "IDAT";
    if (chunk->type != "IEND") continue;
    if (!pixels) return fmt::format("is corrupt (it holds no pixels); {}", restoreIt);
    return {};  // Data after IEND is not part of the picture (PNG specification 5.6).
  }
  return cutOff;
}

/// Returns the next chunk that affects pixels, or nothing if the file is truncated.
std::optional<PngChunk> nextPixelChunk(std::string_view& rest) {
  auto chunk = takePngChunk(rest);
  while (chunk && isText(*chunk)) chunk = takePngChunk(rest);
  return chunk;
}

}  // namespace

void checkPng(std::span<const std::byte> file, const char* what, const std::string& name) {
  const std::string wrong = problem(textOf(file));
  if (!wrong.empty()) fail(ExitCode::inputOutput, "{} {} {}", what, name, wrong);
}

frame::Image readPng(const std::filesystem::path& path, const char* what) {
  std::string file;
  readBytes(path, what, file);
  checkPng(std::as_bytes(std::span(file)), what, path.string());
  Picture picture = decodePicture(file, what, path.string());
  if (picture.depth != Depth::unorm8)
    fail(ExitCode::inputOutput, "{} {} has 16 bits per channel; convert it to 8-bit RGB", what,
         path.string());
  return std::move(picture.image);
}

std::optional<std::pair<int, int>> sizeOfPng(std::span<const std::byte> file) {
  const auto header = pngHeaderOf(textOf(file));
  if (!header) return std::nullopt;
  return std::pair(static_cast<int>(header->width), static_cast<int>(header->height));
}

bool sameEncodedPixels(std::span<const std::byte> a, std::span<const std::byte> b) {
  auto restA = pngChunks(textOf(a)), restB = pngChunks(textOf(b));
  if (!restA || !restB) return false;
  while (true) {
    const auto chunkA = nextPixelChunk(*restA), chunkB = nextPixelChunk(*restB);
    if (!chunkA || !chunkB || chunkA->whole != chunkB->whole) return false;
    if (chunkA->type == "IEND") return true;
  }
}

}  // namespace simreel::golden
