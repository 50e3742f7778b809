#include "sim/particles/file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace simreel::sim {

namespace {

enum Column { columnX, columnY, columnZ, columnVx, columnVy, columnVz, columnMass, columns };
constexpr const char* columnNames[columns] = {"x", "y", "z", "vx", "vy", "vz", "mass"};
using Row = std::array<double, columns>;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

/// Takes the next line off `rest`, without its end.
std::string_view takeLine(std::string_view& rest) {
  const auto end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return trimmed(line);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto end = line.find(separator);
    const std::string_view part = trimmed(line.substr(0, end));
    if (separator != ' ' || !part.empty()) parts.push_back(part);
    if (end == std::string_view::npos) return parts;
    line.remove_prefix(end + 1);
  }
}

/// What separates the values of a file whose first line this is: programs of countries with a decimal comma
/// write semicolons, spreadsheets tabs.
char separatorOf(std::string_view line) {
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ',';
}

/// Parts of a line of CSV, which may be in quotes.
std::vector<std::string_view> splitCsv(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    if (at < line.size() && line[at] == '"') quoted = !quoted;
    if (at < line.size() && (quoted || line[at] != separator)) continue;
    std::string_view part = trimmed(line.substr(begin, at - begin));
    if (part.size() >= 2 && part.front() == '"' && part.back() == '"')
      part = trimmed(part.substr(1, part.size() - 2));
    parts.push_back(part);
    begin = at + 1;
  }
  return parts;
}

std::optional<double> numberOf(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Column> columnOf(std::string_view name) {
  std::string small(name);
  for (char& c : small) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (int i = 0; i < columns; ++i)
    if (small == columnNames[i]) return static_cast<Column>(i);
  return std::nullopt;
}

/// Collects rows, checking each; `place` in messages is "line 7" or "vertex 3".
class Collector {
 public:
  Collector(std::string file, int max) : file_(std::move(file)), max_(max) {}

  template <class... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) const {
    fail(ExitCode::usage, "{}: {}", file_, fmt::format(format, std::forward<Args>(args)...));
  }
  void requirePosition(const std::array<bool, columns>& given) {
    given_ = given;
    for (const Column c : {columnX, columnY, columnZ})
      if (!given[c])
        refuse("no column \"{}\"; particles need x, y, z and may have vx, vy, vz, mass", columnNames[c]);
  }
  void add(const Row& row, const char* what, std::int64_t where) {
    for (int c = 0; c < columns; ++c) {
      if (!given_[static_cast<std::size_t>(c)]) continue;
      const double value = row[static_cast<std::size_t>(c)];
      if (!std::isfinite(value)) refuse("{} {}: {} is not a finite number", what, where, columnNames[c]);
      if (std::abs(value) > 1e7)
        refuse("{} {}: {} = {} is beyond 1e7; scale the file", what, where, columnNames[c], value);
    }
    if (given_[columnMass] && !(row[columnMass] >= 1e-9))
      refuse("{} {}: the mass is {}, it must be at least 1e-9 kg", what, where, row[columnMass]);
    if (static_cast<int>(rows_.size()) == max_)
      refuse("more than {} particles, the most that fit here", max_);
    rows_.push_back(row);
  }
  [[nodiscard]] ParticleCloud cloud(float totalMass) const {
    if (rows_.empty()) refuse("no particles in it");
    ParticleCloud cloud;
    const double fraction = static_cast<double>(totalMass) / static_cast<double>(rows_.size());
    for (const Row& r : rows_) {
      const double mass = given_[columnMass] ? r[columnMass] : fraction;
      cloud.positions.emplace_back(r[columnX], r[columnY], r[columnZ], mass);
      cloud.velocities.emplace_back(r[columnVx], r[columnVy], r[columnVz], 0.0);
    }
    return cloud;
  }

 private:
  std::string file_;
  int max_;
  std::array<bool, columns> given_{};
  std::vector<Row> rows_;
};

void readCsv(std::string_view text, Collector& collector) {
  if (constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF"; text.starts_with(byteOrderMark))
    text.remove_prefix(byteOrderMark.size());
  std::int64_t number = 0;
  std::vector<std::optional<Column>> layout;
  char separator = ',';
  while (!text.empty()) {
    const std::string_view line = takeLine(text);
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (layout.empty()) separator = separatorOf(line);
    const auto parts = splitCsv(line, separator);
    if (layout.empty()) {
      std::array<bool, columns> given{};
      for (const std::string_view part : parts) {
        layout.push_back(columnOf(part));
        if (!layout.back()) continue;
        if (given[*layout.back()]) collector.refuse("line {}: column \"{}\" twice", number, part);
        given[*layout.back()] = true;
      }
      collector.requirePosition(given);
      continue;
    }
    if (parts.size() != layout.size())
      collector.refuse("line {}: {} values, the first line names {} columns", number, parts.size(),
                       layout.size());
    Row row{};
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!layout[i]) continue;
      const auto value = numberOf(parts[i]);
      if (!value) collector.refuse("line {}: \"{}\" is not a number", number, parts[i].substr(0, 40));
      row[*layout[i]] = *value;
    }
    collector.add(row, "line", number);
  }
}

/// A property of a PLY element.
struct Property {
  std::string name;
  int bytes = 0;
  char kind = 'f';  ///< f float, i signed, u unsigned
};

std::optional<Property> propertyOf(std::string_view type, std::string_view name) {
  constexpr struct {
    const char* name;
    int bytes;
    char kind;
  } types[] = {{"char", 1, 'i'},  {"int8", 1, 'i'},    {"uchar", 1, 'u'},  {"uint8", 1, 'u'},
               {"short", 2, 'i'}, {"int16", 2, 'i'},   {"ushort", 2, 'u'}, {"uint16", 2, 'u'},
               {"int", 4, 'i'},   {"int32", 4, 'i'},   {"uint", 4, 'u'},   {"uint32", 4, 'u'},
               {"float", 4, 'f'}, {"float32", 4, 'f'}, {"double", 8, 'f'}, {"float64", 8, 'f'}};
  for (const auto& known : types)
    if (type == known.name) return Property{std::string(name), known.bytes, known.kind};
  return std::nullopt;
}

/// A number of a binary PLY; `at` points to little-endian bytes.
double binaryNumber(const char* at, const Property& property) {
  std::uint64_t bits = 0;
  for (int i = property.bytes - 1; i >= 0; --i) bits = bits << 8U | static_cast<unsigned char>(at[i]);
  if (property.kind == 'f' && property.bytes == 8) return std::bit_cast<double>(bits);
  if (property.kind == 'f') return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  const auto shift = static_cast<unsigned>(64 - 8 * property.bytes);
  if (property.kind == 'i') return static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
  return static_cast<double>(bits);
}

struct PlyHeader {
  bool binary = false;
  std::int64_t vertices = -1;
  std::vector<Property> properties;  ///< of "vertex", which must come first
};

PlyHeader readPlyHeader(std::string_view& text, const Collector& collector) {
  PlyHeader header;
  std::string element;
  bool format = false;
  while (true) {
    if (text.empty()) collector.refuse("the PLY header has no end_header");
    const std::string_view line = takeLine(text);
    const auto words = split(line, ' ');
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info" || words[0] == "ply") continue;
    if (words[0] == "end_header") break;
    if (words[0] == "format" && words.size() > 1) {
      format = true;
      header.binary = words[1] == "binary_little_endian";
      if (!header.binary && words[1] != "ascii")
        collector.refuse("PLY format {}; only ascii and binary_little_endian are read", words[1]);
    } else if (words[0] == "element" && words.size() == 3) {
      if (header.vertices < 0 && words[1] != "vertex")
        collector.refuse("element {} comes before the vertices; write the vertices first", words[1]);
      element = words[1];
      const auto count = numberOf(words[2]);
      if (!count || *count < 0 || *count > 1e15) collector.refuse("\"{}\" is no PLY element", line);
      if (element == "vertex") header.vertices = static_cast<std::int64_t>(*count);
    } else if (words[0] == "property" && words.size() >= 3) {
      if (element != "vertex") continue;
      const auto property = propertyOf(words[1], words[2]);
      if (!property || words.size() != 3)
        collector.refuse("property \"{}\" of the vertices cannot be read", line);
      header.properties.push_back(*property);
    } else {
      collector.refuse("\"{}\" is no line of a PLY header", line.substr(0, 60));
    }
  }
  if (!format || header.vertices < 0) collector.refuse("the PLY header names no format or no vertices");
  return header;
}

void readPly(std::string_view text, Collector& collector) {
  const PlyHeader header = readPlyHeader(text, collector);
  std::array<bool, columns> given{};
  std::size_t bytes = 0;
  for (const Property& property : header.properties) {
    if (const auto column = columnOf(property.name)) given[*column] = true;
    bytes += static_cast<std::size_t>(property.bytes);
  }
  collector.requirePosition(given);
  for (std::int64_t vertex = 0; vertex < header.vertices; ++vertex) {
    Row row{};
    std::vector<std::string_view> words;
    if (header.binary ? text.size() < bytes : text.empty())
      collector.refuse("ends at vertex {} of {}", vertex, header.vertices);
    if (!header.binary) {
      words = split(takeLine(text), ' ');
      if (words.size() != header.properties.size())
        collector.refuse("vertex {}: {} values, the header names {} properties", vertex, words.size(),
                         header.properties.size());
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < header.properties.size(); ++i) {
      const Property& property = header.properties[i];
      const auto value =
          header.binary ? std::optional(binaryNumber(text.data() + at, property)) : numberOf(words[i]);
      at += static_cast<std::size_t>(property.bytes);
      const auto column = columnOf(property.name);
      if (!column) continue;
      if (!value) collector.refuse("vertex {}: \"{}\" is not a number", vertex, words[i].substr(0, 40));
      row[*column] = *value;
    }
    if (header.binary) text.remove_prefix(bytes);
    collector.add(row, "vertex", vertex);
  }
}

}  // namespace

ParticleCloud readParticles(const std::filesystem::path& file, float totalMass, int maxParticles) {
  return parseParticles(readFile(file, "particle file"), file.string(), totalMass, maxParticles);
}

ParticleCloud parseParticles(std::string_view text, const std::string& name, float totalMass,
                             int maxParticles) {
  Collector collector(name, maxParticles);
  if (text.starts_with("ply\n") || text.starts_with("ply\r"))
    readPly(text, collector);
  else
    readCsv(text, collector);
  return collector.cloud(totalMass);
}

}  // namespace simreel::sim
