#include "kernels/source/scan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace simreel::kernels {

std::deque<Scan> scans(const Files& files) {
  std::deque<Scan> made;
  for (std::size_t i = 0; i < files.count(); ++i) made.emplace_back(files.text(i));
  return made;
}

std::size_t closingBracket(const std::vector<Token>& all, std::size_t open) {
  const std::string_view kind = all[open].text;
  const std::string_view close = kind == "(" ? ")" : kind == "[" ? "]" : "}";
  int depth = 0;
  for (std::size_t i = open; i < all.size(); ++i) {
    if (all[i].text == kind) ++depth;
    if (all[i].text == close && --depth == 0) return i;
  }
  return all.size();
}

std::vector<std::pair<std::size_t, std::size_t>> parts(const std::vector<Token>& all, std::size_t begin,
                                                       std::size_t end) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  int depth = 0;
  std::size_t first = begin;
  for (std::size_t i = begin; i <= end && i < all.size(); ++i) {
    const std::string_view text = all[i].text;
    if (i == end || (text == "," && depth == 0)) {
      if (i > first) found.emplace_back(first, i);
      first = i + 1;
    }
    if (text == "(" || text == "[" || text == "{") ++depth;
    if (text == ")" || text == "]" || text == "}") --depth;
  }
  return found;
}

std::size_t bodyOf(const Scan& scan, std::string_view function) {
  for (std::size_t i = 1; i + 1 < scan.all.size(); ++i) {
    const bool named =
        scan.all[i].text == function && scan.all[i + 1].text == "(" && !scan.all[i].directive;
    if (!named || scan.all[i - 1].directive || !scan.all[i - 1].isWord() ||
        scan.all[i - 1].text == "return")
      continue;
    const std::size_t behind = closingBracket(scan.all, i + 1) + 1;
    if (behind < scan.all.size() && scan.all[behind].text == "{") return scan.all[behind].end();
  }
  return 0;
}

std::optional<Numeric> numeric(std::string_view type) {
  static constexpr std::array<std::string_view, 9> bases = {
      "min16float", "min10float", "min16uint", "min16int", "float", "uint", "int", "bool", "half"};
  const auto base =
      std::find_if(bases.begin(), bases.end(), [&](std::string_view one) { return type.starts_with(one); });
  if (base == bases.end()) return std::nullopt;
  type.remove_prefix(base->size());
  const auto size = [](char c) { return c >= '1' && c <= '4' ? c - '0' : 0; };
  if (type.empty()) return Numeric{};
  if (type.size() == 1 && size(type[0]) > 0) return Numeric{size(type[0]), 1, false};
  if (type.size() == 3 && type[1] == 'x' && size(type[0]) > 0 && size(type[2]) > 0)
    return Numeric{size(type[0]), size(type[2]), true};
  return std::nullopt;
}

std::optional<int> wholeNumber(std::string_view word, const std::deque<Scan>& all) {
  int value = 0;
  const auto read = [&](std::string_view text) {
    const char* end = text.data() + text.size();
    return std::from_chars(text.data(), end, value).ptr == end && !text.empty();
  };
  if (read(word)) return value;
  for (const Scan& scan : all)
    for (std::size_t i = 1; i + 2 < scan.all.size(); ++i) {
      if (scan.all[i].text != word) continue;
      const bool macro = scan.all[i].directive && scan.all[i - 1].text == "define";
      if (macro && read(scan.all[i + 1].text)) return value;
      if (scan.all[i + 1].text == "=" && scan.all[i - 1].isWord() && read(scan.all[i + 2].text))
        return value;
    }
  return std::nullopt;
}

}  // namespace simreel::kernels
