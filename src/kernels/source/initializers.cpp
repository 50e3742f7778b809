#include "kernels/source/initializers.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

/// Type of a variable, and its array lengths, outermost first. Length 0 stands for "[]".
struct Variable {
  std::string_view type;
  std::vector<int> lengths;
};

using Structs = std::map<std::string, std::vector<Variable>, std::less<>>;

/// Reads array lengths "[3][N]" from token `i` and moves `i` to the token after them. Returns nullopt if a
/// length is unknown.
std::optional<std::vector<int>> lengthsAt(const Scan& scan, std::size_t& i, const std::deque<Scan>& all) {
  std::vector<int> lengths;
  while (i < scan.all.size() && scan.all[i].text == "[") {
    const std::size_t close = closingBracket(scan.all, i);
    if (close == i + 1) {
      lengths.push_back(0);
    } else {
      const auto length = close == i + 2 ? wholeNumber(scan.all[i + 1].text, all) : std::nullopt;
      if (!length || *length < 1) return std::nullopt;
      lengths.push_back(*length);
    }
    i = close + 1;
  }
  return lengths;
}

/// Reads the members of "struct NAME {" whose brace is token `open`. Returns nullopt if the struct contains
/// methods or preprocessor lines.
std::optional<std::vector<Variable>> membersOf(const Scan& scan, std::size_t open,
                                               const std::deque<Scan>& all) {
  const std::size_t close = closingBracket(scan.all, open);
  std::vector<Variable> members;
  for (std::size_t i = open + 1; i + 1 < close;) {
    if (!scan.all[i].isWord() || scan.all[i].directive) return std::nullopt;
    const std::string_view type = scan.all[i].text;
    do {
      ++i;
      if (i >= close || !scan.all[i].isWord()) return std::nullopt;
      auto lengths = lengthsAt(scan, ++i, all);
      if (!lengths) return std::nullopt;
      members.push_back({type, *lengths});
    } while (scan.all[i].text == ",");
    if (scan.all[i].text == ":") i += 2;
    if (i >= scan.all.size() || scan.all[i].text != ";") return std::nullopt;
    ++i;
  }
  return members;
}

Structs structsOf(const std::deque<Scan>& all) {
  Structs found;
  for (const Scan& scan : all)
    for (std::size_t i = 0; i + 2 < scan.all.size(); ++i)
      if (scan.all[i].text == "struct" && scan.all[i + 2].text == "{")
        if (auto members = membersOf(scan, i + 2, all))
          found.emplace(std::string(scan.all[i + 1].text), std::move(*members));
  return found;
}

/// An item of an initializer list. `count` is the number of scalars in the item, or 0 if the text does not
/// reveal it.
struct Item {
  std::size_t begin, end;
  int count;
};

/// Assigns the items of an initializer list to the scalars of a type, in order.
class Fill {
 public:
  /// `vectors`: true if an item of unknown size has as many scalars as a vector, false if it is one scalar.
  Fill(const Structs& structs, const std::vector<Item>& items, bool vectors)
      : structs_(structs), items_(items), vectors_(vectors) {}

  /// Returns the insertions for a variable. Returns nullopt if the items do not fill the variable exactly.
  std::optional<Edits> done(const Variable& variable) {
    const bool filled = array(variable, 0, true) && next_ == items_.size();
    if (!filled || opening_.empty()) return std::nullopt;
    Edits edits;
    for (const auto& [at, text] : opening_) edits.insert(at, text);
    for (const auto& [at, text] : closing_) edits.insert(at, text);
    return edits;
  }

 private:
  bool array(const Variable& variable, std::size_t level, bool outer) {
    if (level == variable.lengths.size()) return single(variable.type, outer);
    const int length = variable.lengths[level];
    const std::size_t first = next_;
    if (length == 0 && !outer) return false;
    for (int i = 0; length == 0 ? next_ < items_.size() : i < length; ++i)
      if (!array(variable, level + 1, false)) return false;
    if (!outer) brace(first, "{", "}");
    return true;
  }
  bool single(std::string_view type, bool outer) {
    if (const auto one = numeric(type)) return numbers(type, one->count(), outer);
    const auto known = structs_.find(type);
    if (known == structs_.end() || depth_ > 8) return false;
    const std::size_t first = next_;
    ++depth_;
    for (const Variable& member : known->second)
      if (!array(member, 0, false)) return false;
    --depth_;
    if (!outer) brace(first, "{", "}");
    return true;
  }
  bool numbers(std::string_view type, int count, bool outer) {
    const std::size_t first = next_;
    for (int filled = 0; filled < count; ++next_) {
      if (next_ == items_.size()) return false;
      const int own = items_[next_].count;
      filled += own > 0 ? own : vectors_ && filled == 0 ? count : 1;
      if (filled > count) return false;
    }
    if (next_ > first + 1 && !outer) brace(first, fmt::format("{}(", type), ")");
    return true;
  }
  /// Inserts brackets around the items from `first` to the current one, outside existing brackets.
  void brace(std::size_t first, std::string_view open, std::string_view close) {
    if (first == next_) return;
    opening_[items_[first].begin].insert(0, open);
    closing_[items_[next_ - 1].end] += close;
  }

  const Structs& structs_;
  const std::vector<Item>& items_;
  bool vectors_;
  std::size_t next_ = 0;
  int depth_ = 0;
  std::map<std::size_t, std::string> opening_, closing_;
};

/// Returns the number of scalars in an expression, judged by its first token. Returns 0 if unknown.
int countOf(const Scan& scan, std::size_t begin, std::size_t end) {
  if (scan.all[begin].text == "-" || scan.all[begin].text == "+") ++begin;
  const std::string_view text = scan.all[begin].text;
  const bool literal = std::isdigit(static_cast<unsigned char>(text.front())) != 0 || text == "." ||
                       text == "true" || text == "false";
  if (literal) return 1;
  const auto made = numeric(text);
  const bool call = begin + 1 < end && scan.all[begin + 1].text == "(";
  return made && call && closingBracket(scan.all, begin + 1) + 1 == end ? made->count() : 0;
}

/// Returns the insertions for "TYPE NAME[..] = {" whose brace is token `open`.
std::optional<Edits> nested(const Scan& scan, std::size_t open, const std::deque<Scan>& all,
                            const Structs& structs) {
  std::size_t name = open - 2;
  while (name > 1 && scan.all[name].text == "]")
    while (name > 1 && scan.all[name--].text != "[") {
    }
  if (name < 1 || !scan.all[name].isWord() || !scan.all[name - 1].isWord()) return std::nullopt;
  std::size_t behind = name + 1;
  auto lengths = lengthsAt(scan, behind, all);
  if (!lengths || behind + 1 != open) return std::nullopt;
  std::vector<Item> items;
  for (const auto& [begin, end] : parts(scan.all, open + 1, closingBracket(scan.all, open))) {
    const bool braces = std::any_of(scan.all.begin() + static_cast<std::ptrdiff_t>(begin),
                                    scan.all.begin() + static_cast<std::ptrdiff_t>(end),
                                    [](const Token& one) { return one.text == "{" || one.directive; });
    if (braces) return std::nullopt;
    items.push_back({scan.all[begin].at, scan.all[end - 1].end(), countOf(scan, begin, end)});
  }
  const Variable variable{scan.all[name - 1].text, std::move(*lengths)};
  for (const bool vectors : {true, false})
    if (auto edits = Fill(structs, items, vectors).done(variable)) return edits;
  return std::nullopt;
}

}  // namespace

Edits nestedInitializers(const std::deque<Scan>& all, std::size_t file) {
  const Structs structs = structsOf(all);
  const Scan& scan = all[file];
  Edits edits;
  for (std::size_t i = 3; i < scan.all.size(); ++i)
    if (scan.all[i].text == "{" && scan.all[i - 1].text == "=" && !scan.all[i].directive)
      if (const auto more = nested(scan, i, all, structs)) edits.add(*more);
  return edits;
}

}  // namespace simreel::kernels
