#include "frame/file/picture_origin.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/png.hpp"
#include "frame/png_text.hpp"
#include "scene/scene.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <glm/vec2.hpp>

namespace simreel::frame {

namespace {

/// Size and text entries of a picture's header.
struct PictureHeader {
  std::optional<glm::ivec2> size;
  std::map<std::string, std::string> texts;
};

/// Reads a little-endian 32-bit word.
std::uint32_t headerWord(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i-- > 0;) word = word << 8U | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

PictureHeader headerOfPng(std::span<const std::byte> file, std::string_view bytes) {
  PictureHeader header;
  if (const auto said = pngHeaderOf(bytes)) header.size = glm::ivec2(said->width, said->height);
  for (auto& [keyword, text] : readPngText(file)) header.texts[keyword] = std::move(text);
  return header;
}

/// Reads the attributes of an OpenEXR header up to the empty name that ends it. An attribute has a name, a
/// type, a 4-byte size and a value (OpenEXR file layout).
PictureHeader headerOfExr(std::string_view bytes) {
  PictureHeader header;
  constexpr std::size_t magicAndVersion = 8, box = 16;
  bytes.remove_prefix(std::min(bytes.size(), magicAndVersion));
  const auto word = [&]() -> std::optional<std::string> {
    const std::size_t end = bytes.find('\0');
    if (end == std::string_view::npos) return std::nullopt;
    std::string text(bytes.substr(0, end));
    bytes.remove_prefix(end + 1);
    return text;
  };
  while (true) {
    const auto name = word();
    if (!name || name->empty()) return header;
    const auto type = word();
    if (!type || bytes.size() < 4) return header;
    const std::size_t size = headerWord(bytes, 0);
    bytes.remove_prefix(4);
    if (size > bytes.size()) return header;
    const std::string_view value = bytes.substr(0, size);
    if (*type == "string") header.texts[*name] = value;
    const auto side = [&](std::size_t i) { return static_cast<int>(headerWord(value, 4 * i)); };
    if (*name == "dataWindow" && size == box)
      header.size = glm::ivec2(side(2), side(3)) - glm::ivec2(side(0), side(1)) + 1;
    bytes.remove_prefix(size);
  }
}

PictureHeader pictureHeader(std::span<const std::byte> file) {
  const std::string_view bytes(reinterpret_cast<const char*>(file.data()), file.size());
  if (bytes.starts_with("\x89PNG")) return headerOfPng(file, bytes);
  if (bytes.starts_with("\x76\x2f\x31\x01")) return headerOfExr(bytes);
  return {};
}

}  // namespace

PictureOrigin originOf(std::span<const std::byte> file, const std::filesystem::path& name,
                       const RunInfo& run, int frame) {
  PictureHeader header = pictureHeader(file);
  auto& texts = header.texts;
  PictureOrigin origin;
  origin.identified = texts.contains("simreel:scene") && texts.contains("simreel:frame");
  const auto compare = [&](const char* item, const std::string& here, const std::string& there) {
    if (here != there && origin.difference.empty())
      origin.difference =
          fmt::format("{} is {} in this run and {} in {}", item, here, there, name.string());
  };
  const auto sizeText = [](int width, int height) { return fmt::format("{}x{}", width, height); };
  if (header.size)
    compare("size", sizeText(run.width, run.height), sizeText(header.size->x, header.size->y));
  if (!origin.identified) return origin;
  const auto changes = scene::asArguments(run.overrides);
  const auto listed = [](const std::string& text) { return text.empty() ? std::string("nothing") : text; };
  compare("what is changed in the scene", listed(changes), listed(texts["simreel:overrides"]));
  compare("scene hash", run.sceneHash, texts["simreel:scene"]);
  compare("seed", std::to_string(run.seed), texts["simreel:seed"]);
  origin.otherRun = !origin.difference.empty();
  compare("frame", std::to_string(frame), texts["simreel:frame"]);
  origin.state = texts["simreel:state"];
  origin.driver = texts["simreel:driver"];
  return origin;
}

std::string reasonToKeep(const std::filesystem::path& file, const RunInfo& run, int frame, bool listed) {
  if (!pathExists(file)) return {};
  std::string bytes;
  try {
    bytes = readFile(file, "picture");
  } catch (const UserError& error) {
    return error.what();
  }
  if (bytes.find_first_not_of('\0') == std::string::npos) return {};
  const auto content = std::as_bytes(std::span(bytes));
  const PictureOrigin origin = originOf(content, file, run, frame);
  if (origin.identified) return origin.otherRun && !listed ? origin.difference : std::string();
  if (listed && bytes.starts_with("\x89PNG") && !isWholePng(content)) return {};
  return file.string() + " is no picture of simreel";
}

}  // namespace simreel::frame
