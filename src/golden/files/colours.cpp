#include "golden/files/colours.hpp"

#include "base/hash.hpp"
#include "base/png.hpp"
#include "base/text.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::golden {

namespace {

using Words = std::vector<std::string>;

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size, bool littleEnd = false) {
  std::uint32_t value = 0;
  if (at + size > bytes.size()) return 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + (littleEnd ? size - 1 - i : i)]);
  return value;
}

std::string profileWords(std::string_view name, std::string_view bytes) {
  constexpr std::size_t digits = 8;
  return fmt::format("the colour profile {}({})", name.empty() ? "" : oneLine(name) + " ",
                     hashHex(bytes).substr(0, digits));
}

/// Uses the precedence of the PNG specification, 11.3.2: cICP, then iCCP, then sRGB, then gAMA and cHRM.
Words ofPng(std::string_view bytes) {
  std::string cicp, profile, gamma, primaries;
  bool srgb = false;
  std::string_view rest = pngChunks(bytes).value_or("");
  while (const auto chunk = takePngChunk(rest)) {
    const auto [type, data, whole] = *chunk;
    if (type == "IDAT") break;
    if (type == "cICP") cicp = fmt::format("the colour space {:02x}", fmt::join(data, ""));
    if (type == "iCCP") profile = profileWords(data.substr(0, data.find('\0')), data);
    if (type == "sRGB") srgb = true;
    constexpr std::uint32_t usual = 45455;  // gamma 1 / 2.2, in units of 1/100000
    if (type == "gAMA" && number(data, 0, 4) != usual)
      gamma = fmt::format("gamma {:g}", number(data, 0, 4) / 1e5);
    if (type == "cHRM" && (number(data, 0, 4) != 31270 || number(data, 8, 4) != 64000))
      primaries = fmt::format("primaries of their own ({})", hashHex(data).substr(0, 8));
  }
  if (!cicp.empty()) return {cicp};
  if (!profile.empty()) return {profile};
  Words words;
  if (!srgb)
    for (const std::string& one : {gamma, primaries})
      if (!one.empty()) words.push_back(one);
  return words;
}

/// Returns the orientation, which is tag 0x0112 of the first directory (Exif 2.3, 4.6.4). The value 1 means
/// upright.
std::uint32_t orientation(std::string_view tiff) {
  const bool little = tiff.starts_with("II");
  const std::size_t directory = number(tiff, 4, 4, little);
  const std::uint32_t entries = number(tiff, directory, 2, little);
  constexpr std::size_t entrySize = 12;
  for (std::uint32_t i = 0; i < entries && directory + 2 + entrySize * (i + 1) <= tiff.size(); ++i) {
    const std::size_t entry = directory + 2 + entrySize * i;
    if (number(tiff, entry, 2, little) == 0x0112) return number(tiff, entry + 8, 2, little);
  }
  return 1;
}

Words ofJpeg(std::string_view bytes) {
  std::string profile;
  Words words;
  for (std::size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xff';) {
    const auto marker = static_cast<unsigned char>(bytes[at + 1]);
    if (marker == 0xda || marker == 0xd9) break;
    if (marker == 0xff) {
      ++at;
      continue;
    }
    const std::size_t length = number(bytes, at + 2, 2);
    std::string_view data = bytes.substr(at + 4, length < 2 ? 0 : length - 2);
    if (marker == 0xe2 && data.starts_with("ICC_PROFILE")) profile += data;
    if (marker == 0xe1 && data.starts_with(std::string_view("Exif\0\0", 6)))
      if (const std::uint32_t turned = orientation(data.substr(6)); turned > 1)
        words.push_back(fmt::format("turned (Exif orientation {})", turned));
    at += 2 + length;
  }
  if (!profile.empty()) words.push_back(profileWords("", profile));
  return words;
}

Words ofRadiance(std::string_view bytes) {
  Words words;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::string_view line = bytes.substr(at, bytes.substr(at).find('\n'));
    if (line.empty()) break;
    for (const std::string_view key : {"EXPOSURE=", "COLORCORR=", "PRIMARIES="})
      if (line.starts_with(key)) words.push_back(oneLine(line.substr(0, 80)));
    at += line.size() + 1;
  }
  return words;
}

}  // namespace

std::string colourWords(std::string_view bytes) {
  Words words;
  if (bytes.starts_with("\x89PNG")) words = ofPng(bytes);
  if (bytes.starts_with("\xff\xd8")) words = ofJpeg(bytes);
  if (bytes.starts_with("#?")) words = ofRadiance(bytes);
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace simreel::golden
