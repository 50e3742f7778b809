#include "kernels/source/overloads.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr std::size_t maxShortened = 5;  // max number of shortened parameters of one function; n shortened
                                         // parameters make 2^n - 1 overloads

/// A parameter of a function.
struct Parameter {
  std::string text;    ///< declaration as in the source: "const float2 at"
  std::string longer;  ///< the same declaration with a larger type; empty if none exists
  std::string name;
  std::string shorter;  ///< argument shortened to the original type: "at.x"
};

std::string between(const Scan& scan, std::size_t begin, std::size_t end) {
  if (begin >= end) return {};
  std::string text = scan.code.substr(scan.all[begin].at, scan.all[end - 1].end() - scan.all[begin].at);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// Parses a parameter. Returns nullopt if it has a default value.
std::optional<Parameter> parameter(const Scan& scan, std::size_t begin, std::size_t end) {
  std::size_t type = begin;
  bool written = false;
  for (; type + 1 < end; ++type) {
    const std::string_view word = scan.all[type].text;
    if (word == "out" || word == "inout")
      written = true;
    else if (word != "in" && word != "const" && word != "uniform" && word != "precise")
      break;
  }
  std::size_t name = end - 1;
  while (name > type && scan.all[name].text != "]" && !scan.all[name].isWord()) --name;
  const bool array = scan.all[name].text == "]";
  while (name > type && !scan.all[name].isWord()) --name;
  const bool plain = name == end - 1 && name == type + 1;
  if (std::any_of(scan.all.begin() + static_cast<std::ptrdiff_t>(begin),
                  scan.all.begin() + static_cast<std::ptrdiff_t>(end),
                  [](const Token& one) { return one.text == "=" || one.text == ":" || one.directive; }))
    return std::nullopt;
  Parameter made{between(scan, begin, end), {}, std::string(scan.all[name].text), {}};
  if (array)  // The parameter's name is before the first bracket.
    for (std::size_t i = type + 1; i < end; ++i)
      if (scan.all[i].text == "[") {
        made.name = std::string(scan.all[i - 1].text);
        break;
      }
  const std::string_view own = scan.all[type].text;
  const auto kind = plain && !written ? numeric(own) : std::nullopt;
  if (kind && kind->count() == 1 && !kind->matrix) {
    made.longer = fmt::format("{}2 {}", own.substr(0, own.find_last_not_of('1') + 1), made.name);
    made.shorter = made.name + ".x";
  } else if (kind && kind->matrix && kind->count() < 16) {
    made.longer = fmt::format("{}4x4 {}", own.substr(0, own.size() - 3), made.name);
    made.shorter = fmt::format("({}){}", own, made.name);
  }
  return made;
}

/// Returns the overloads of the function whose name is token `name` and whose parameter list begins with
/// token `open`.
std::string overloads(const Scan& scan, std::size_t name, std::size_t open) {
  std::size_t begin = name;
  const auto stops = [](const Token& one) {
    return one.directive || one.text == ";" || one.text == "}" || one.text == "{" || one.text == "]";
  };
  while (begin > 0 && !stops(scan.all[begin - 1])) --begin;
  if (begin == name) return {};
  const std::string result = between(scan, begin, name);
  std::vector<Parameter> parameters;
  std::vector<std::size_t> shortened;
  for (const auto& [first, last] : parts(scan.all, open + 1, closingBracket(scan.all, open))) {
    auto one = parameter(scan, first, last);
    if (!one) return {};
    if (!one->longer.empty()) shortened.push_back(parameters.size());
    parameters.push_back(std::move(*one));
  }
  if (shortened.empty() || shortened.size() > maxShortened) return {};
  std::string text;
  for (unsigned which = 1; which < 1U << shortened.size(); ++which) {
    std::string heads, arguments;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto at = std::find(shortened.begin(), shortened.end(), i) - shortened.begin();
      const bool longer = (which >> static_cast<unsigned>(at) & 1U) != 0;
      heads += (i == 0 ? "" : ", ") + (longer ? parameters[i].longer : parameters[i].text);
      arguments += (i == 0 ? "" : ", ") + (longer ? parameters[i].shorter : parameters[i].name);
    }
    const std::string_view call = result.ends_with("void") ? "" : "return ";
    text += fmt::format(" {} {}({}) {{ {}{}({}); }}", result, scan.all[name].text, heads, call,
                        scan.all[name].text, arguments);
  }
  return text;
}

}  // namespace

Edits shorteningOverloads(const Scan& scan, std::string_view name) {
  Edits edits;
  for (std::size_t i = 1; i + 1 < scan.all.size(); ++i) {
    const bool begins = scan.all[i].text == name && scan.all[i + 1].text == "(" && !scan.all[i].directive;
    if (!begins || !(scan.all[i - 1].isWord() || scan.all[i - 1].text == ">")) continue;
    const std::size_t body = closingBracket(scan.all, i + 1) + 1;
    if (body >= scan.all.size() || scan.all[body].text != "{") continue;
    const std::size_t close = closingBracket(scan.all, body);
    if (close < scan.all.size()) edits.insert(scan.all[close].end(), overloads(scan, i, i + 1));
  }
  return edits;
}

}  // namespace simreel::kernels
