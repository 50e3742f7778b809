#include "golden/files/picture.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/png.hpp"
#include "base/srgb.hpp"
#include "base/text.hpp"
#include "golden/files/colours.hpp"
#include "golden/files/damage.hpp"
#include "golden/files/png_check.hpp"
#include "sim/grid/stb_picture.hpp"
#include "sim/light/light_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

namespace simreel::golden {

namespace fs = std::filesystem;

namespace {

enum class Kind { png, jpeg, exr, radiance, pnm, other };

Kind kindOf(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return Kind::png;
  if (bytes.starts_with("\xff\xd8\xff")) return Kind::jpeg;
  if (sim::isExr(bytes)) return Kind::exr;
  if (sim::isRadiance(bytes)) return Kind::radiance;
  if (bytes.starts_with("P5") || bytes.starts_with("P6")) return Kind::pnm;
  return Kind::other;
}

/// Returns the name of a known but unsupported format, or an empty text.
std::string foreignKind(std::string_view bytes) {
  if (bytes.starts_with("GIF8")) return "a GIF";
  if (bytes.starts_with("BM")) return "a BMP";
  if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "a WebP picture";
  if (bytes.starts_with("II*") || bytes.starts_with(std::string_view("MM\0*", 4))) return "a TIFF";
  if (bytes.substr(0, 12).find("ftypavif") != std::string_view::npos) return "an AVIF picture";
  if (bytes.starts_with("DDS ")) return "a DDS texture";
  if (bytes.substr(1).starts_with("KTX ")) return "a KTX texture";
  return {};
}

/// True if a JPEG is complete. Reads all segments up to a scan, then the scan's bytes up to the next
/// marker, and so on (ITU-T T.81, annex B). The check is needed because the decoder silently fills missing
/// parts with grey.
bool jpegHasItsEnd(std::string_view bytes) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::size_t i = 2;
  while (i + 1 < bytes.size()) {
    if (at(i) != 0xff) {  // inside the compressed data of a scan
      ++i;
      continue;
    }
    const int marker = at(i + 1);
    if (marker == 0xd9) return true;
    const bool alone = marker == 0 || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    if (marker == 0xff)
      ++i;
    else if (alone)
      i += 2;
    else if (i + 3 < bytes.size())
      i += 2 + (std::size_t{at(i + 2)} << 8 | at(i + 3));
    else
      return false;
  }
  return false;
}

float encoded(float light) {
  if (!std::isfinite(light)) return light;
  return std::copysign(static_cast<float>(srgbOfLinear(std::abs(light))), light);
}

std::uint8_t rounded(float value) {
  return value > 0 ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.0F))) : std::uint8_t{0};
}

std::string labelOf(const char* what, const std::string& name) {
  return fmt::format("{} {}", what, name);
}

}  // namespace

void readBytes(const fs::path& path, const char* what, std::string& bytes) {
  const auto failed = [&](const char* verb) {
    fail(ExitCode::inputOutput, "cannot {} {} {}: {}", verb, what, path.string(), std::strerror(errno));
  };
  // Checks the type first, because opening a pipe without a writer would block forever.
  std::error_code unknown;
  const auto kind = fs::status(path, unknown).type();
  if (kind == fs::file_type::fifo || kind == fs::file_type::character || kind == fs::file_type::block ||
      kind == fs::file_type::socket)
    fail(ExitCode::inputOutput, "{} {} is a pipe, a device or a socket; copy what it gives into a file",
         what, path.string());
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rbe"),
                                                               &std::fclose);
  if (!stream) failed("open");
  std::setvbuf(stream.get(), nullptr, _IONBF, 0);  // unbuffered: reads directly into `bytes`
  const auto size = fs::file_size(path, unknown);
  bytes.resize(unknown ? 65536 : size + 1);
  std::size_t used = 0;
  while (const std::size_t got = std::fread(bytes.data() + used, 1, bytes.size() - used, stream.get())) {
    used += got;
    if (used == bytes.size()) bytes.resize(2 * used);
  }
  if (std::ferror(stream.get()) != 0) failed("read");
  bytes.resize(used);
}

namespace {

/// Calls `read`. Removes the advice to restore the file from error messages, unless the file is a baseline.
/// A picture that a program has just made cannot be restored. The program must make it again.
template <class Read>
auto advised(const char* what, const Read& read) {
  try {
    return read();
  } catch (const UserError& error) {
    const std::string advice = std::string("; ") + restoreIt;
    std::string message = error.what();
    if (std::string_view(what).starts_with("baseline") || !message.ends_with(advice)) throw;
    message.resize(message.size() - advice.size());
    throw UserError(error.code(), message);
  }
}

/// Decodes a PNG with 16 bits per channel.
Picture decodeDeep(std::string_view bytes, const std::string& label) {
  const auto refuse = [&](const std::string& why) {
    fail(ExitCode::inputOutput, "{} cannot be decoded ({})", label, oneLine(why));
  };
  if (bytes.size() > std::size_t{1} << 30) refuse("larger than 1 GiB");
  const auto size = sim::stbSize(bytes);
  if (!size) refuse(sim::stbReason());
  if (size->x < 1 || size->y < 1) refuse("no width or no height");
  const std::size_t pixels = std::size_t(size->x) * std::size_t(size->y);
  if (pixels > maxPicturePixels)
    refuse(
        fmt::format("{}x{}, more than {} million pixels", size->x, size->y, maxPicturePixels / 1'000'000));
  // deflate expands each byte to at most 1032 bytes, and a pixel has at least two bytes
  if (static_cast<double>(pixels) * 2 > static_cast<double>(bytes.size()) * 1032)
    refuse(fmt::format("{}x{} pixels do not fit in its {} bytes", size->x, size->y, bytes.size()));
  const auto values = sim::stbDecode<std::uint16_t>(bytes, *size);
  if (!values) refuse(sim::stbReason());
  Picture picture{{size->x, size->y, {}}, Depth::unorm16, {}, {}, {}};
  picture.values.assign(values->begin(), values->end());
  picture.image.bytes.resize(4 * pixels);
  for (std::size_t i = 0; i < 4 * pixels; ++i)
    picture.image.bytes[i] = static_cast<std::uint8_t>(((*values)[i] + 128U) / 257U);
  return picture;
}

/// Decodes a picture with 8 bits per channel.
Picture decodeShallow(std::string_view bytes, const std::string& label, const std::string& name) {
  try {
    return {frame::decodeImage(std::as_bytes(std::span(bytes)), name), Depth::unorm8, {}, {}, {}};
  } catch (const UserError& error) {
    // Extracts the reason in parentheses from messages like "the image a.png is not a picture this program
    // reads (not enough pixels); use PNG or JPEG".
    const std::string_view message = error.what();
    const auto open = message.rfind(" ("), close = message.rfind(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) throw;
    fail(error.code(), "{} cannot be decoded{}; {}", label, message.substr(open, close - open + 1),
         restoreIt);
  }
}

void check(std::string_view bytes, const char* what, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    fail(ExitCode::inputOutput, "{} {} {}", what, name, why);
  };
  if (const std::string other = placeholderProblem(bytes); !other.empty()) refuse(other);
  if (bytes.empty()) refuse(fmt::format("is empty; {}", restoreIt));
  switch (kindOf(bytes)) {
    case Kind::png:
      return checkPng(std::as_bytes(std::span(bytes)), what, name);
    case Kind::jpeg:
      if (!jpegHasItsEnd(bytes))
        refuse(fmt::format("is cut off after {} bytes; {}", bytes.size(), restoreIt));
      return;
    case Kind::other: {
      if (pngSignature.starts_with(bytes))
        refuse(fmt::format("is cut off after {} bytes; {}", bytes.size(), restoreIt));
      const std::string foreign = foreignKind(bytes);
      refuse(fmt::format("is {}; convert it to PNG, JPEG, HDR or EXR",
                         foreign.empty() ? "not a picture that this program reads" : foreign));
      return;
    }
    case Kind::exr:
    case Kind::radiance:
    case Kind::pnm:
      return;
  }
}

/// Fills `image` from `values`, which are linear light.
void showLight(Picture& picture, int width, int height) {
  picture.depth = Depth::linear;
  picture.image = {width, height, std::vector<std::uint8_t>(picture.values.size())};
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.image.bytes[i] = rounded(255 * (i % 4 == 3 ? picture.values[i] : encoded(picture.values[i])));
}

Picture ofLight(sim::LightFile file) {
  Picture picture;
  picture.values = std::move(file.values);
  picture.colours = std::move(file.colours);
  showLight(picture, file.size.x, file.size.y);
  return picture;
}

Picture decode(std::string_view bytes, const char* what, const std::string& name) {
  check(bytes, what, name);
  const Kind kind = kindOf(bytes);
  if (kind == Kind::exr) {
    Picture picture = ofLight(sim::decodeExr(bytes, labelOf(what, name), restoreIt));
    picture.layers = readExrLayers(bytes, labelOf(what, name));
    picture.layered = true;
    // If a layer's part has another display window, the layer does not have a value for each pixel. Such a
    // layer is compared only by its hash.
    for (PictureLayer& layer : picture.layers)
      if (layer.kind != PictureLayer::Kind::content && layer.bits.size() != picture.values.size() / 4)
        layer = {
            layer.name, PictureLayer::Kind::content, {}, hashHex(std::as_bytes(std::span(layer.bits)))};
    return picture;
  }
  if (kind == Kind::radiance) return ofLight(sim::decodeRadiance(bytes, labelOf(what, name), restoreIt));
  if (kind == Kind::png && pngHeaderOf(bytes)->depth == 16) return decodeDeep(bytes, labelOf(what, name));
  return decodeShallow(bytes, labelOf(what, name), name);
}

}  // namespace

void checkPicture(std::string_view bytes, const char* what, const std::string& name) {
  advised(what, [&] { check(bytes, what, name); });
}

Picture decodePicture(std::string_view bytes, const char* what, const std::string& name) {
  Picture picture = advised(what, [&] { return decode(bytes, what, name); });
  if (picture.colours.empty()) picture.colours = colourWords(bytes);
  return picture;
}

Picture readPicture(const fs::path& path, const char* what) {
  std::string bytes;
  readBytes(path, what, bytes);
  return decodePicture(bytes, what, path.string());
}

bool isPictureName(const fs::path& file) {
  constexpr std::array<std::string_view, 19> endings = {
      ".png", ".jpg", ".jpeg", ".hdr", ".exr",  ".pnm", ".ppm", ".pgm", ".gif", ".webp",
      ".bmp", ".tif", ".tiff", ".tga", ".avif", ".jxl", ".dds", ".ktx", ".pfm"};
  const std::string ending = lowerExtension(file);
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

bool holdsPicture(const fs::path& file) {
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown)) return false;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rbe"),
                                                               &std::fclose);
  std::array<char, 8> first{};
  const std::size_t read = stream ? std::fread(first.data(), 1, first.size(), stream.get()) : 0;
  const Kind kind = kindOf(std::string_view(first.data(), read));
  return kind == Kind::png || kind == Kind::jpeg || kind == Kind::exr;
}

std::string pictureHash(const Picture& picture) {
  const auto pixels = picture.depth == Depth::unorm8 ? std::as_bytes(std::span(picture.image.bytes))
                                                     : std::as_bytes(std::span(picture.values));
  std::string all = fmt::format("{}x{} {} {}", picture.image.width, picture.image.height,
                                static_cast<int>(picture.depth), hashHex(pixels));
  for (const PictureLayer& layer : picture.layers)
    all += fmt::format(" {} {}", layer.name,
                       layer.kind == PictureLayer::Kind::content
                           ? layer.hash
                           : hashHex(std::as_bytes(std::span(layer.bits))));
  return hashHex(all);
}

std::vector<float> inUnits(const Picture& picture) {
  if (picture.depth == Depth::unorm8) return {picture.image.bytes.begin(), picture.image.bytes.end()};
  std::vector<float> units(picture.values.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    const float value = picture.values[i];
    const bool alpha = i % 4 == 3;
    units[i] = picture.depth == Depth::unorm16 ? value / 257 : 255 * (alpha ? value : encoded(value));
  }
  return units;
}

Picture padded(const Picture& picture, int width, int height) {
  const auto& from = picture.image;
  Picture made = picture;
  const auto enlarge = [&](const auto& old, auto& grown, std::ptrdiff_t each = 4) {
    grown.assign(std::size_t(width) * std::size_t(height) * std::size_t(each), {});
    for (int y = 0; y < from.height; ++y)
      std::copy_n(old.begin() + each * y * from.width, each * from.width, grown.begin() + each * y * width);
  };
  enlarge(from.bytes, made.image.bytes);
  if (!picture.values.empty()) enlarge(picture.values, made.values);
  for (std::size_t i = 0; i < made.layers.size(); ++i)
    if (made.layers[i].kind != PictureLayer::Kind::content)
      enlarge(picture.layers[i].bits, made.layers[i].bits, 1);
  made.image.width = width;
  made.image.height = height;
  return made;
}

}  // namespace simreel::golden
