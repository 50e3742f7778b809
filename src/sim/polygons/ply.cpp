#include "sim/polygons/ply.hpp"

#include "base/text.hpp"
#include "sim/polygons/problem.hpp"
#include "sim/polygons/words.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

std::optional<PlyType> plyTypeNamed(std::string_view name) {
  constexpr std::pair<std::string_view, PlyType> types[] = {
      {"char", {1, 'i'}},  {"int8", {1, 'i'}},    {"uchar", {1, 'u'}},  {"uint8", {1, 'u'}},
      {"short", {2, 'i'}}, {"int16", {2, 'i'}},   {"ushort", {2, 'u'}}, {"uint16", {2, 'u'}},
      {"int", {4, 'i'}},   {"int32", {4, 'i'}},   {"uint", {4, 'u'}},   {"uint32", {4, 'u'}},
      {"float", {4, 'f'}}, {"float32", {4, 'f'}}, {"double", {8, 'f'}}, {"float64", {8, 'f'}}};
  for (const auto& [known, type] : types)
    if (name == known) return type;
  return std::nullopt;
}

double binaryNumber(const char* at, const PlyType& type, bool bigEndian) {
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < type.bytes; ++i)
    bits |= std::uint64_t{static_cast<unsigned char>(at[bigEndian ? type.bytes - 1 - i : i])} << 8 * i;
  if (type.kind == 'f')
    return type.bytes == 8 ? std::bit_cast<double>(bits)
                           : double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
  const unsigned shift = 64 - 8 * type.bytes;
  if (type.kind == 'i') return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
  return static_cast<double>(bits);
}

/// Returns the minimum number of bytes of an item.
std::uint64_t minBytes(const PlyElement& element, bool binary) {
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    bytes += !binary ? 2 : property.counts ? property.counts->bytes : property.type.bytes;
  return bytes;
}

std::string whichItem(const PlyElement& element, std::uint64_t item) {
  return fmt::format("at {} {} of {}", oneLine(element.name.substr(0, 40)), item, element.count);
}

[[noreturn]] void endsEarly(const PlyElement& element, std::uint64_t item) {
  throw PolygonProblem("is cut off " + whichItem(element, item));
}

/// Reads the numbers of the text format and counts lines.
class PlyText {
 public:
  PlyText(std::string_view text, std::size_t linesBefore) : lines_(text), before_(linesBefore) {}

  double number(const PlyElement& element, std::uint64_t item) {
    std::string_view word = takeWord(line_);
    while (word.empty()) {
      if (!lines_.next(line_)) endsEarly(element, item);
      word = takeWord(line_);
    }
    const auto value = doubleIn(word);
    if (!value) wrong(fmt::format("{}, where a number is expected", inQuotes(word)));
    return *value;
  }
  void endItem() {
    if (withoutBlanks(line_).empty()) return;
    wrong(fmt::format("more numbers than the header has properties ({})", inQuotes(line_)));
  }
  [[nodiscard]] std::string_view rest() const { return lines_.rest(); }

 private:
  [[noreturn]] void wrong(const std::string& why) const {
    throw PolygonProblem(fmt::format("has in line {} {}", before_ + lines_.number(), why));
  }

  TextLines lines_;
  std::string_view line_;
  std::size_t before_;
};

/// Converts the length of a list to an integer. Throws if it is not a valid count.
std::size_t lengthOf(double count, const PlyElement& element, std::uint64_t item) {
  constexpr double maximum = 4e9;
  if (!(count >= 0 && count < maximum) || count != std::floor(count))
    throw PolygonProblem(fmt::format("has a list of {} values {}", count, whichItem(element, item)));
  return static_cast<std::size_t>(count);
}

}  // namespace

int PlyElement::find(std::initializer_list<std::string_view> names, bool list) const {
  for (std::size_t i = 0; i < properties.size(); ++i)
    if (properties[i].counts.has_value() == list &&
        std::find(names.begin(), names.end(), properties[i].name) != names.end())
      return static_cast<int>(i);
  return -1;
}

PlyFile::PlyFile(std::string_view text) : bytes_(text.size()) {
  // The line ending of the first line applies to all header lines, because binary data may begin with a
  // byte that looks like a line ending.
  const std::size_t end = text.find_first_of("\r\n");
  const bool macintosh =
      end != std::string_view::npos && text[end] == '\r' && !text.substr(end).starts_with("\r\n");
  while (!text.empty()) {
    const std::size_t stop = std::min(text.find(macintosh ? '\r' : '\n'), text.size());
    const std::string_view line = withoutBlanks(text.substr(0, stop));
    text.remove_prefix(std::min(stop + 1, text.size()));
    ++lines_;
    if (line == "end_header" && lines_ > 1) {
      body_ = text;
      if (!hasFormat_) throw PolygonProblem("has no format in its header");
      for (const PlyElement& element : elements_)
        if (const std::uint64_t minimum = minBytes(element, binary_);
            minimum > 0 && element.count > (bytes_ + 1) / minimum)
          throw PolygonProblem(fmt::format("promises {} elements in {} bytes", element.count, bytes_));
      return;
    }
    takeHeaderLine(line, lines_);
  }
  throw PolygonProblem("has no \"end_header\"");
}

void PlyFile::takeHeaderLine(std::string_view line, std::size_t number) {
  const auto refuse = [&] {
    throw PolygonProblem(
        fmt::format("has in line {} {}, which is no line of a PLY header", number, inQuotes(line)));
  };
  if (number == 1) {
    if (line != "ply") refuse();
    return;
  }
  std::string_view rest = line;
  const std::string_view key = takeWord(rest);
  if (key == "comment" || key == "obj_info") {
    comments_.emplace_back(withoutBlanks(rest));
    return;
  }
  std::vector<std::string_view> words;
  for (std::string_view word = takeWord(rest); !word.empty(); word = takeWord(rest)) words.push_back(word);
  if (key == "format" && words.size() == 2 && !hasFormat_) {
    hasFormat_ = true;
    bigEndian_ = words[0] == "binary_big_endian";
    binary_ = bigEndian_ || words[0] == "binary_little_endian";
    if (!binary_ && words[0] != "ascii") refuse();
    if (words[1] != "1.0")
      throw PolygonProblem(
          fmt::format("has in line {} {}; only version 1.0 is read", number, inQuotes(line)));
  } else if (key == "element" && words.size() == 2) {
    if (words[1].find_first_not_of("0123456789") != std::string_view::npos) refuse();
    std::uint64_t count = 0;
    const auto error = std::from_chars(words[1].data(), words[1].data() + words[1].size(), count).ec;
    if (error != std::errc())
      throw PolygonProblem(fmt::format("promises {} elements in {} bytes", words[1], bytes_));
    elements_.push_back({std::string(words[0]), count, {}});
  } else if (key == "property" && words.size() == 2 && !elements_.empty()) {
    const auto type = plyTypeNamed(words[0]);
    if (!type) refuse();
    elements_.back().properties.push_back({std::string(words[1]), *type, {}});
  } else if (key == "property" && words.size() == 4 && words[0] == "list" && !elements_.empty()) {
    const auto counts = plyTypeNamed(words[1]), type = plyTypeNamed(words[2]);
    if (!counts || !type) refuse();
    if (counts->kind == 'f')
      throw PolygonProblem(
          fmt::format("has in line {} {}; a list's length is a whole number", number, inQuotes(line)));
    elements_.back().properties.push_back({std::string(words[3]), *type, counts});
  } else {
    refuse();
  }
}

std::size_t PlyFile::read(const Visit& visit) const {
  std::string_view rest = body_;
  if (binary_)
    readBinary(visit, rest);
  else
    readText(visit, rest);
  return rest.find_first_not_of(" \t\r\n") == std::string_view::npos ? 0 : rest.size();
}

void PlyFile::readText(const Visit& visit, std::string_view& rest) const {
  PlyText text(rest, lines_);
  PlyItem values;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const PlyElement& element = elements_[e];
    if (element.properties.empty()) continue;
    for (std::uint64_t item = 0; item < element.count; ++item) {
      values.values_.clear();
      values.ends_.clear();
      for (const PlyProperty& property : element.properties) {
        std::size_t count = 1;
        if (property.counts) count = lengthOf(text.number(element, item), element, item);
        for (; count > 0; --count) values.values_.push_back(text.number(element, item));
        values.ends_.push_back(values.values_.size());
      }
      text.endItem();
      visit(e, item, values);
    }
  }
  rest = text.rest();
}

void PlyFile::readBinary(const Visit& visit, std::string_view& rest) const {
  PlyItem values;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    const PlyElement& element = elements_[e];
    if (element.properties.empty()) continue;
    const auto nextValue = [&](const PlyType& type, std::uint64_t item) {
      if (rest.size() < type.bytes) endsEarly(element, item);
      const double value = binaryNumber(rest.data(), type, bigEndian_);
      rest.remove_prefix(type.bytes);
      return value;
    };
    for (std::uint64_t item = 0; item < element.count; ++item) {
      values.values_.clear();
      values.ends_.clear();
      for (const PlyProperty& property : element.properties) {
        std::size_t count = 1;
        if (property.counts) count = lengthOf(nextValue(*property.counts, item), element, item);
        if (count > rest.size() / property.type.bytes) endsEarly(element, item);
        for (; count > 0; --count) values.values_.push_back(nextValue(property.type, item));
        values.ends_.push_back(values.values_.size());
      }
      visit(e, item, values);
    }
  }
}

}  // namespace simreel::sim
