#include "sim/life/cell_pattern.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/gzip.hpp"
#include "sim/life/macrocell.hpp"
#include "sim/life/rle.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

namespace simreel::sim {

namespace {

constexpr std::size_t maxFileBytes = std::size_t{256} << 20;
constexpr std::size_t maxUnpackedBytes = std::size_t{64} << 20;

/// Parser of formats whose lines are rows of cells or cell coordinates.
class LineReader : public PatternText {
 public:
  using PatternText::PatternText;

  /// Parses plaintext. Lines that begin with '!' are comments; all other lines are rows.
  CellPattern plaintext() {
    for (std::string_view line; next(line);)
      if (!line.starts_with('!')) row(line);
    return fitted();
  }

  /// Parses Life 1.05. "#P x y" begins a block of rows, "#R 23/3" names the rule, and "#N" stands for
  /// Conway's rule.
  CellPattern life105() {
    for (std::string_view line; next(line);) {
      if (line.starts_with("#P")) {
        // "#P" without coordinates begins a block at the current row.
        if (std::size_t at = 2; line.size() > at) {
          block_.x = number(line, at);
          block_.y = number(line, at);
          row_ = 0;
        }
      } else if (line.starts_with("#R") || line.starts_with("#r")) {
        takeRule(line);
      } else if (line.starts_with("#N")) {
        pattern_.rule = LifeRule{};
      } else if (!line.starts_with('#')) {
        row(line);
      }
    }
    return fitted();
  }

  /// Parses Life 1.06. Each line holds the coordinates of a live cell.
  CellPattern life106() {
    for (std::string_view line; next(line);) {
      if (line.starts_with('#') || line.find_first_not_of(" \t") == std::string_view::npos) continue;
      std::size_t at = 0;
      const int x = number(line, at);
      const int y = number(line, at);
      if (line.find_first_not_of(" \t", at) != std::string_view::npos)
        wrong(place_ + at, "a line holds the place of one cell, as \"3 -1\"");
      add(x, y, 1);
    }
    return fitted();
  }

 private:
  /// Reads the next line without its line end, and sets place_ to the offset of its start.
  bool next(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    place_ = at_;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    line = text_.substr(at_, end - at_);
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.remove_suffix(1);
    at_ = end + 1;
    return true;
  }

  void row(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (c == 'O' || c == '*')
        add(block_.x + static_cast<int>(i), block_.y + row_, 1);
      else if (c != '.')
        wrong(place_ + i, fmt::format("{} in a row of cells: '.' is dead, 'O' or '*' alive", shown(c)));
      if (i >= maxLifeSide) wrong(place_ + i, fmt::format("a row of more than {} cells", maxLifeSide));
    }
    if (++row_ > maxLifeSide) wrong(place_, fmt::format("more than {} rows", maxLifeSide));
  }

  int number(std::string_view line, std::size_t& at) const {
    at = std::min(line.find_first_not_of(" \t", at), line.size());
    int value = 0;
    const auto [end, error] = std::from_chars(line.data() + at, line.data() + line.size(), value);
    if (error == std::errc::invalid_argument)
      wrong(place_ + at, "a whole number is missing here: places are as \"3 -1\"");
    if (error != std::errc() || value > maxPlace || value < -maxPlace)
      wrong(place_ + at, fmt::format("a place beyond {}, the farthest that is allowed", maxPlace));
    at = static_cast<std::size_t>(end - line.data());
    return value;
  }

  void takeRule(std::string_view line) {
    const std::size_t at = std::min(line.find_first_not_of(" \t", 2), line.size());
    takeRuleText(place_ + at, line.substr(at));
  }

  /// Translates the live cells so that their minimum x and y are 0.
  CellPattern fitted() {
    constexpr int far = std::numeric_limits<int>::max();
    glm::ivec2 min(far), end(-far);
    for (const CellPattern::Run& run : pattern_.runs) {
      min = {std::min(min.x, run.x), std::min(min.y, run.y)};
      end = {std::max(end.x, run.x + run.length), std::max(end.y, run.y + 1)};
    }
    if (pattern_.runs.empty()) return std::move(pattern_);
    pattern_.size = end - min;
    if (std::max(pattern_.size.x, pattern_.size.y) > maxLifeSide)
      wrong(0, fmt::format("the living cells are {} x {} apart, more than {}, the maximum", pattern_.size.x,
                           pattern_.size.y, maxLifeSide));
    for (CellPattern::Run& run : pattern_.runs) {
      run.x -= min.x;
      run.y -= min.y;
    }
    return std::move(pattern_);
  }

  static constexpr int maxPlace = 1 << 28;
  std::size_t place_ = 0;   ///< offset of the current line's start
  glm::ivec2 block_{0, 0};  ///< for Life 1.05: position of the top left cell of the current block
  int row_ = 0;
};

/// Returns true if the first line that is not a plaintext comment is a row of cells.
bool isPlaintext(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.remove_suffix(1);
    if (line.starts_with('!')) return true;
    if (!line.empty()) return line.find_first_not_of(".O*") == std::string_view::npos;
  }
  return false;
}

}  // namespace

void PatternText::wrong(std::size_t at, const std::string& message) const {
  fail(ExitCode::usage, "{}: {}", place(at), message);
}

std::string PatternText::place(std::size_t at) const {
  const std::string_view before = text_.substr(0, at);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const auto start = before.rfind('\n');
  const std::size_t column = at - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return fmt::format("{}:{}:{}", name_, line, column);
}

void PatternText::takeRuleText(std::size_t at, std::string_view text) {
  CellRule rule;
  const RuleProblem problem = parseCellRule(text, rule);
  const bool bornOnly = !problem.message.empty() && (text.starts_with('B') || text.starts_with('b')) &&
                        text.find_first_of("/_sS") == std::string_view::npos &&
                        parseCellRule(fmt::format("{}/S", text), rule).message.empty();
  if (problem.message.empty() || bornOnly) {
    pattern_.rule = rule;
    return;
  }
  const bool name = isRuleName(text);
  if (!name) wrong(at + problem.at, problem.message);
  pattern_.ruleName = text;
  pattern_.rulePlace = place(at);
}

std::string PatternText::shown(char c) {
  return c >= ' ' && c <= '~' ? fmt::format("'{}'", c)
                              : fmt::format("a byte {:#04x}", static_cast<unsigned char>(c));
}

void PatternText::add(int x, int y, int length, int state, std::size_t from) {
  std::vector<CellPattern::Run>& runs = pattern_.runs;
  if (state > pattern_.highest) {
    pattern_.highest = state;
    pattern_.highestPlace = place(from);
  }
  if (!runs.empty() && runs.back().y == y && runs.back().state == state &&
      runs.back().x + runs.back().length == x)
    runs.back().length += length;
  else
    runs.push_back({x, y, length, state});
}

bool isPatternName(const std::filesystem::path& file) {
  std::string extension = lowerExtension(file);
  if (extension == ".gz") extension = lowerExtension(file.stem());
  return extension == ".rle" || extension == ".cells" || extension == ".life" || extension == ".lif" ||
         extension == ".mc";
}

CellPattern parsePattern(std::string_view text, const std::string& name) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
  LineReader lines(text, name);
  if (text.starts_with("#Life 1.05")) return lines.life105();
  if (text.starts_with("#Life 1.06")) return lines.life106();
  if (text.starts_with("#Life"))
    lines.wrong(0, "of the formats that begin with \"#Life\" only 1.05 and 1.06 are known");
  if (text.starts_with("[M2]")) return parseMacrocell(text, name);
  if (isPlaintext(text)) return lines.plaintext();
  return parseRle(text, name);
}

CellPattern readPattern(const std::filesystem::path& file) {
  const std::string bytes = readFile(file, "pattern", maxFileBytes);
  if (isGzip(bytes))
    return parsePattern(unpackedGzip(bytes, file.string(), maxUnpackedBytes), file.string());
  return parsePattern(bytes, file.string());
}

}  // namespace simreel::sim
