#include "scene/json/words.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::scene {

namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

/// Returns the edit distance of two names (insertions, deletions, replacements, swaps of neighbours),
/// ignoring case.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> twoBefore, before, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    twoBefore = std::exchange(before, row);
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = before[j] + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      row[j + 1] = std::min({replaced, row[j] + 1, before[j + 1] + 1});
      const bool swapped =
          i > 0 && j > 0 && lower(a[i]) == lower(b[j - 1]) && lower(a[i - 1]) == lower(b[j]);
      if (swapped) row[j + 1] = std::min(row[j + 1], twoBefore[j - 1] + 1);
    }
  }
  return row.back();
}

}  // namespace

bool isPlainName(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), plain);
}

std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = codePointLength(text, at);
    const std::string_view character = text.substr(at, std::max<std::size_t>(length, 1));
    out += length == 0 || isTerminalControl(character) ? "?" : character;
    at += character.size();
  }
  return out;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t max = 60;
  if (text.size() <= max) return fmt::format("\"{}\"", text);
  std::size_t cut = max;
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) --cut;
  return fmt::format("\"{}...\"", text.substr(0, cut));
}

std::string suggestion(std::string_view unknown, std::span<const std::string> names) {
  const std::string* best = nullptr;
  std::size_t bestDistance = std::max<std::size_t>(1, unknown.size() / 3) + 1;
  for (const std::string& name : names) {
    // The edit distance of two names is at least the difference of their lengths, so names whose lengths
    // differ much are skipped. This also bounds the cost for a very long name.
    if (std::max(name.size(), unknown.size()) - std::min(name.size(), unknown.size()) >= bestDistance)
      continue;
    if (unknown.size() > 2 * name.size() + 8) continue;
    const std::size_t distance = editDistance(unknown, name);
    if (distance < bestDistance) {
      best = &name;
      bestDistance = distance;
    }
  }
  if (best != nullptr) return fmt::format("did you mean \"{}\"?", *best);
  if (names.empty()) return "nothing is known here";
  return fmt::format("known here: {}", fmt::join(names, ", "));
}

std::string splitCamelCase(std::string_view camelCase, char between) {
  std::string words;
  for (const char c : camelCase) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital) words += between;
    words += capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return words;
}

}  // namespace simreel::scene
