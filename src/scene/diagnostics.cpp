#include "scene/diagnostics.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::scene {

namespace {

constexpr std::size_t mostErrors = 50;
constexpr std::size_t mostColumns = 120;

bool continuesCharacter(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Characters, not bytes.
std::size_t length(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continuesCharacter(c); }));
}

/// Least number of insertions, deletions and replacements, case ignored.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = std::tolower(static_cast<unsigned char>(a[i - 1])) ==
                        std::tolower(static_cast<unsigned char>(b[j - 1]));
      const std::size_t next = std::min({row[j] + 1, row[j - 1] + 1, corner + (same ? 0 : 1)});
      corner = row[j];
      row[j] = next;
    }
  }
  return row[b.size()];
}

/// Control characters would disturb the terminal and the caret's column.
std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
  return result;
}

}  // namespace

std::string Diagnostics::one(const JsonError& error) const {
  const std::string& text = sources_[error.place.source];
  const std::size_t at = std::min(error.place.begin, text.size());
  const auto newline = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t lineBegin = newline == std::string::npos ? 0 : newline + 1;
  const std::size_t lineEnd = std::min(text.find('\n', at), text.size());
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(lineBegin), '\n') + 1;
  const std::size_t column = length(std::string_view(text).substr(lineBegin, at - lineBegin)) + 1;
  const std::string where = error.place.source == 0 ? fmt::format("{}:{}:{}", name_, line, column)
                                                    : fmt::format("-D {}", printable(text));
  if (error.place.source != 0) return fmt::format("{}: error: {}", where, error.message);
  // A very long line is shown around the mistake only.
  std::size_t from = lineBegin;
  if (at - from > mostColumns / 2) from = at - mostColumns / 2;
  while (from > lineBegin && continuesCharacter(text[from])) --from;
  std::size_t to = std::min(lineEnd, from + mostColumns);
  while (to < lineEnd && continuesCharacter(text[to])) ++to;
  const std::string excerpt = printable(std::string_view(text).substr(from, to - from));
  const std::size_t caret = length(std::string_view(text).substr(from, at - from));
  const std::size_t stop = std::clamp(error.place.end, at, std::max(at, to));
  const std::size_t width = std::max<std::size_t>(1, length(std::string_view(text).substr(at, stop - at)));
  return fmt::format("{}: error: {}\n  {}\n  {}^{}", where, error.message, excerpt, std::string(caret, ' '),
                     std::string(width - 1, '~'));
}

std::string Diagnostics::text() const {
  auto sorted = errors_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const JsonError& a, const JsonError& b) {
    return std::tie(a.place.source, a.place.begin) < std::tie(b.place.source, b.place.begin);
  });
  std::string result;
  for (std::size_t i = 0; i < std::min(sorted.size(), mostErrors); ++i)
    result += (i == 0 ? "" : "\n") + one(sorted[i]);
  if (sorted.size() > mostErrors) result += fmt::format("\n{}: and {} more", name_, sorted.size() - mostErrors);
  return result;
}

std::string nearest(std::string_view wrong, const std::vector<std::string>& names) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, wrong.size() / 3) + 1;
  for (const std::string& name : names) {
    const std::size_t distance = editDistance(wrong, name);
    if (distance < least) {
      least = distance;
      best = name;
    }
  }
  return best;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& names) {
  const std::string near = nearest(wrong, names);
  return near.empty() ? fmt::format("known: {}", fmt::join(names, ", ")) : fmt::format("did you mean \"{}\"?", near);
}

}  // namespace simreel::scene
