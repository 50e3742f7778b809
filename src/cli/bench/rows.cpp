#include "cli/bench/rows.hpp"

#include "base/error.hpp"
#include "scene/value/choices.hpp"

#include <algorithm>

#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

constexpr std::size_t maxCases = 64;

/// Splits text at commas outside brackets, braces and quotes.
std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  bool quoted = false;
  bool escaped = false;
  for (const char c : text) {
    if (c == ',' && depth == 0 && !quoted) {
      parts.emplace_back();
      continue;
    }
    if (c == '"' && !escaped) quoted = !quoted;
    escaped = quoted && c == '\\' && !escaped;
    if (!quoted) depth += int{c == '[' || c == '{'} - int{c == ']' || c == '}'};
    parts.back() += c;
  }
  return parts;
}

std::vector<std::string> techniquesOf(const scene::Object& object, std::span<const scene::Kind> kinds) {
  for (const scene::Kind& kind : kinds)
    if (object.kind == kind.name) return scene::choicesOf(kind, "technique");
  return {};
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::vector<BenchChoice> parseVary(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    fail(ExitCode::usage,
         "--vary {}: expected path=value,value,..., for example --vary objects.flag.cloth.substeps=4,8",
         text);
  const std::string path = text.substr(0, equals);
  const std::string last = path.substr(path.rfind('.') + 1);
  std::vector<BenchChoice> choices;
  for (const std::string& value : split(std::string_view(text).substr(equals + 1))) {
    if (value.empty()) fail(ExitCode::usage, "--vary {}: a value is missing between commas", text);
    choices.push_back({fmt::format("{}={}", last, value), {{path, value}}});
  }
  return choices;
}

std::vector<BenchChoice> parseTechniques(const std::string& text, const scene::Scene& scene,
                                         std::span<const scene::Kind> kinds) {
  std::vector<std::string> known;
  for (const scene::Object& object : scene.objects)
    for (const std::string& word : techniquesOf(object, kinds))
      if (!holds(known, word)) known.push_back(word);
  if (known.empty())
    fail(ExitCode::usage,
         "--technique {}: no object of this scene has techniques to choose from; --vary path=a,b compares "
         "values of any parameter",
         text);
  std::vector<BenchChoice> choices;
  for (const std::string& word : text == "all" ? known : split(text)) {
    if (!holds(known, word))
      fail(ExitCode::usage, "--technique {}: no object of this scene has this technique; use all, {}", word,
           fmt::join(known, ", "));
    BenchChoice choice{word, {}};
    for (const scene::Object& object : scene.objects)
      if (holds(techniquesOf(object, kinds), word))
        choice.changes.push_back({fmt::format("objects.{}.{}.technique", object.name, object.kind), word});
    choices.push_back(std::move(choice));
  }
  return choices;
}

std::vector<BenchCase> combine(std::span<const std::vector<BenchChoice>> lists, const std::string& plain) {
  std::vector<BenchCase> cases(1);
  for (const std::vector<BenchChoice>& list : lists) {
    std::vector<BenchCase> longer;
    if (cases.size() * list.size() > maxCases)
      fail(ExitCode::usage, "more than {} combinations to time; give fewer values", maxCases);
    for (const BenchCase& one : cases)
      for (const BenchChoice& choice : list) {
        BenchCase both = one;
        both.name += (one.name.empty() ? "" : ", ") + choice.name;
        both.changes.insert(both.changes.end(), choice.changes.begin(), choice.changes.end());
        longer.push_back(std::move(both));
      }
    cases = std::move(longer);
  }
  if (cases.front().name.empty()) cases.front().name = plain;
  return cases;
}

}  // namespace simreel::cli
