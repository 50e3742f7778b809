#include "sim/particles/file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "sim/polygons/ply.hpp"
#include "sim/polygons/problem.hpp"
#include "sim/polygons/words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/ranges.h>

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

/// Removes the next line from `rest` and returns it without its line end.
std::string_view takeLine(std::string_view& rest) {
  const auto end = rest.find('\n');
  const std::string_view line = rest.substr(0, end);
  rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  return trimmed(line);
}

/// Returns the separator used in the first line of a CSV file. Programs in locales with a decimal comma
/// write semicolons, and spreadsheets write tabs.
char separatorOf(std::string_view line) {
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ',';
}

/// Splits a CSV line into its values, which may be quoted.
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

/// Collects rows of particles and validates each row. For messages, `what` and `where` form "line 7" or
/// "vertex 3".
class Collector {
 public:
  Collector(std::string file, int max) : file_(std::move(file)), max_(max) {}

  template <class... Args>
  [[noreturn]] void refuse(fmt::format_string<Args...> format, Args&&... args) const {
    fail(ExitCode::inputOutput, "{}: {}", file_, fmt::format(format, std::forward<Args>(args)...));
  }
  void requirePosition(const std::array<bool, columns>& given) {
    given_ = given;
    for (const Column c : {columnX, columnY, columnZ})
      if (!given[c])
        refuse("no column \"{}\"; particles need x, y, z and may have vx, vy, vz, mass", columnNames[c]);
  }
  /// Warns once about columns that are not used, because their names may be misspelt.
  void noteUnused(const std::vector<std::string>& names) const {
    constexpr std::size_t maximum = 8;
    if (names.empty()) return;
    std::string list = fmt::format(
        "{}",
        fmt::join(names.begin(),
                  names.begin() + static_cast<std::ptrdiff_t>(std::min(maximum, names.size())), ", "));
    if (names.size() > maximum) list += fmt::format(" and {} more", names.size() - maximum);
    warnLinesOnce("simreel: warning: " +
                  oneLine(fmt::format("{}: not used: column{} {}; particles have x, y, z, vx, vy, vz, mass",
                                      file_, names.size() == 1 ? "" : "s", list)));
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
      fail(ExitCode::usage, "{}: more than {} particles, the most that fit here", file_, max_);
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
  std::vector<std::string> unused;
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
        if (!layout.back()) {
          if (!part.empty()) unused.push_back(inQuotes(part));
          continue;
        }
        if (given[*layout.back()]) collector.refuse("line {}: column \"{}\" twice", number, part);
        given[*layout.back()] = true;
      }
      collector.requirePosition(given);
      collector.noteUnused(unused);
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

void readPly(std::string_view text, Collector& collector) {
  try {
    const PlyFile file(text);
    std::array<bool, columns> given{};
    std::array<std::size_t, columns> properties{};
    std::vector<std::string> unused;
    std::size_t vertices = 0;
    while (vertices < file.elements().size() && file.elements()[vertices].name != "vertex") ++vertices;
    if (vertices == file.elements().size()) collector.refuse("has no vertices");
    const std::vector<PlyProperty>& all = file.elements()[vertices].properties;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const auto column = columnOf(all[i].name); column && !all[i].counts) {
        given[*column] = true;
        properties[*column] = i;
      } else {
        unused.push_back(inQuotes(all[i].name));
      }
    collector.requirePosition(given);
    collector.noteUnused(unused);
    file.read([&](std::size_t element, std::uint64_t item, const PlyItem& values) {
      if (element != vertices) return;
      Row row{};
      for (std::size_t c = 0; c < columns; ++c)
        if (given[c]) row[c] = values[properties[c]];
      collector.add(row, "vertex", static_cast<std::int64_t>(item));
    });
  } catch (const PolygonProblem& problem) {
    collector.refuse("{}", problem.what());
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
