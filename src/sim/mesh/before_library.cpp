#include "sim/mesh/before_library.hpp"

#include "sim/mesh/builder.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line.substr(0, line.find_last_not_of(blanks) + 1);
}

/// Where words begin and how long they are, one after the other.
template <class Each>
void eachWord(std::string_view text, const Each& each) {
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    each(text.substr(at, end - at));
    at = text.find_first_not_of(blanks, end);
  }
}

template <std::size_t Count>
bool isOneOf(std::string_view word, const std::array<std::string_view, Count>& known) {
  return std::find(known.begin(), known.end(), word) != known.end();
}

bool isType(std::string_view word) {
  static constexpr std::array<std::string_view, 16> types = {
      "char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
      "int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
  return isOneOf(word, types);
}

bool isPlyLine(const std::vector<std::string_view>& words) {
  static constexpr std::array<std::string_view, 3> formats = {"ascii", "binary_little_endian",
                                                              "binary_big_endian"};
  const std::size_t count = words.size();
  if (words[0] == "format") return count == 3 && isOneOf(words[1], formats);
  if (words[0] == "element")
    return count == 3 && words[2].find_first_not_of("0123456789") == std::string_view::npos;
  if (words[0] != "property" || count < 3) return false;
  if (words[1] == "list") return count == 5 && isType(words[2]) && isType(words[3]);
  return count == 3 && isType(words[1]);
}

}  // namespace

void checkObj(const std::filesystem::path& file, std::string_view text) {
  std::size_t corners = 0, line = 0, first = 0;
  bool counts = false, goesOn = false;
  while (!text.empty()) {
    std::string_view words = takeLine(text);
    ++line;
    if (!goesOn) {
      words.remove_prefix(std::min(words.find_first_not_of(blanks), words.size()));
      counts = words.starts_with('f') || words.starts_with('l') || words.starts_with('p');
      if (counts) words.remove_prefix(1);
      corners = 0;
      first = line;
    }
    goesOn = words.ends_with('\\');  // in the next line
    if (goesOn) words.remove_suffix(1);
    if (counts) eachWord(words, [&](std::string_view) { ++corners; });
    if (corners > maxCorners)
      refuseMesh(file, fmt::format("has a face of {} corners (line {}), more than {}; cut it up", corners,
                                   first, maxCorners));
  }
}

void checkPly(const std::filesystem::path& file, std::string_view text) {
  const std::size_t bytes = text.size();
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::string_view line = takeLine(text);
    std::vector<std::string_view> words;
    eachWord(line, [&](std::string_view word) { words.push_back(word); });
    if (words.empty()) words = {line};
    if (words[0] == "end_header" && number > 1) return;
    const bool isFirst = number == 1 && line == "ply";
    if (words[0] == "comment" || words[0] == "obj_info" || isFirst) continue;
    if (number == 1 || !isPlyLine(words))
      refuseMesh(file, fmt::format("has in line {} \"{}\", which is no line of a PLY header", number,
                                   line.substr(0, 60)));
    if (words[0] != "element") continue;
    std::uint64_t count = 0;
    const char* const end = words[2].data() + words[2].size();
    if (std::from_chars(words[2].data(), end, count).ec != std::errc() || count > bytes)
      refuseMesh(file, fmt::format("promises {} elements in {} bytes", words[2], bytes));
  }
  refuseMesh(file, "has no \"end_header\"");
}

}  // namespace simreel::sim
