#include "sim/automata/file/rule_text.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace simreel::sim {

namespace {

bool blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

std::string_view bareText(std::string_view text) {
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

bool begins(std::string_view line, std::string_view section) {
  return line.starts_with(section) && (line.size() == section.size() || blank(line[section.size()]));
}

}  // namespace

RuleFileText::RuleFileText(std::string_view text, std::string name) : name_(std::move(name)) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines_.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

int RuleFileText::find(std::string_view name) const {
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (begins(lines_[i], name)) return static_cast<int>(i);
  return -1;
}

std::vector<RuleFileText::Line> RuleFileText::section(std::string_view name) const {
  std::vector<Line> result;
  const int first = find(name);
  if (first < 0) return result;
  for (auto i = static_cast<std::size_t>(first); i < lines_.size(); ++i) {
    std::string_view line = lines_[i];
    if (static_cast<int>(i) == first)
      line.remove_prefix(name.size());
    else if (line.starts_with('@'))
      break;
    line = bareText(line.substr(0, line.find('#')));
    if (!line.empty())
      result.push_back(
          {static_cast<int>(i) + 1, static_cast<std::size_t>(line.data() - lines_[i].data()), line});
  }
  return result;
}

void RuleFileText::wrong(const Line& line, std::size_t at, const std::string& message) const {
  fail(ExitCode::usage, "{}:{}:{}: {}", name_, line.number, line.column + at + 1, message);
}

void RuleFileText::wrong(const std::string& message) const {
  fail(ExitCode::usage, "{}: {}", name_, message);
}

int RuleFileText::number(const Line& line, std::size_t at, std::string_view word, int max,
                         const char* what) const {
  long value = -1;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range) value = max + 1L;
  if ((error != std::errc() && error != std::errc::result_out_of_range) ||
      end != word.data() + word.size() || value < 0)
    wrong(line, at, fmt::format("\"{}\" where {} is expected, a number from 0 to {}", word, what, max));
  if (value > max) wrong(line, at, fmt::format("{} is {} here; it is at most {}", what, word, max));
  return static_cast<int>(value);
}

std::vector<RuleWord> wordsOf(std::string_view text, bool commas) {
  std::vector<RuleWord> result;
  std::size_t at = 0;
  while (at <= text.size()) {
    std::size_t end = at;
    while (end < text.size() && (commas ? text[end] != ',' : !blank(text[end]))) ++end;
    std::string_view word = text.substr(at, end - at);
    const std::string_view bare = bareText(word);
    if (commas || !bare.empty())
      result.push_back({bare.empty() ? at : static_cast<std::size_t>(bare.data() - text.data()), bare});
    at = end + 1;
  }
  return result;
}

}  // namespace simreel::sim
