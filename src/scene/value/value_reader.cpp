#include "scene/value/value_reader.hpp"

#include "scene/json/words.hpp"
#include "scene/value/color_text.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::scene {

std::string rangeText(Range range, const char* unit) {
  const std::string suffix = *unit == '\0' ? "" : fmt::format(" {}", unit);
  const bool below = range.min > anyNumber.min, above = range.max < anyNumber.max;
  if (range.min == positive.min) {
    return above ? fmt::format("greater than 0 and at most {:g}{}", range.max, suffix)
                 : "greater than 0" + suffix;
  }
  if (below && above) return fmt::format("between {} and {}{}", range.min, range.max, suffix);
  if (below) return fmt::format("at least {}{}", range.min, suffix);
  if (above) return fmt::format("at most {}{}", range.max, suffix);
  return {};
}

bool ValueReader::expect(const Node& node, Node::Kind kind, const char* expected) const {
  if (node.kind == kind) return true;
  if (*name_ != '\0' && node.kind == Node::Kind::object && node.find("keys") != nullptr) {
    diagnostics_.add(node.place(), fmt::format("expected {}, found keyframes; \"{}\" cannot have keyframes",
                                               expected, name_));
    return false;
  }
  diagnostics_.add(node.place(), fmt::format("expected {}, found {}", expected, node.kindText()));
  return false;
}

bool ValueReader::isList(const Node& node, const char* expected) const {
  return expect(node, Node::Kind::list, expected);
}

bool ValueReader::inRange(const Node& node) const {
  if (node.number >= range_.min && node.number <= range_.max) return true;
  // Messages normally omit bounds beyond 1e9. If the value violates such a bound, the message must state
  // it.
  const bool tiny = range_.min == positive.min && node.number > 0 && node.number < positive.min;
  const bool beyond = tiny || std::abs(node.number) > anyNumber.max;
  const std::string unit = *unit_ == '\0' ? "" : fmt::format(" {}", unit_);
  const std::string allowed = beyond ? fmt::format("between {:g} and {:g}{}", range_.min, range_.max, unit)
                                     : rangeText(range_, unit_);
  diagnostics_.add(node.place(), fmt::format("\"{}\" must be {}, found {}", name_, allowed, node.number));
  return false;
}

std::optional<bool> ValueReader::boolean(const Node& node) const {
  if (!expect(node, Node::Kind::boolean, "true or false")) return std::nullopt;
  return node.boolean;
}

std::optional<double> ValueReader::number(const Node& node) const {
  if (!expect(node, Node::Kind::number, "a number") || !inRange(node)) return std::nullopt;
  return node.number;
}

std::optional<int> ValueReader::wholeNumber(const Node& node, const char* expected) const {
  if (!expect(node, Node::Kind::number, expected)) return std::nullopt;
  if (node.number != std::floor(node.number)) {
    diagnostics_.add(node.place(), fmt::format("expected {}, found {}", expected, node.number));
    return std::nullopt;
  }
  if (!inRange(node)) return std::nullopt;
  if (std::abs(node.number) > std::numeric_limits<int>::max()) {  // Such a number is possible only if no
                                                                  // range is declared.
    diagnostics_.add(node.place(), fmt::format("\"{}\" must fit in 32 bits, found {}", name_, node.number));
    return std::nullopt;
  }
  return static_cast<int>(node.number);
}

std::optional<int> ValueReader::integer(const Node& node) const {
  return wholeNumber(node, "a whole number");
}

std::optional<std::string> ValueReader::text(const Node& node) const {
  if (!expect(node, Node::Kind::text, "a string")) return std::nullopt;
  return node.text;
}

std::optional<glm::vec3> ValueReader::vector(const Node& node, Flat flat) const {
  const char* const wanted = flat.axis < 0 ? "a list of three numbers" : "a list of two or three numbers";
  if (!expect(node, Node::Kind::list, wanted)) return std::nullopt;
  const bool two = flat.axis >= 0 && node.children.size() == 2;
  if (node.children.size() != 3 && !two) {
    diagnostics_.add(node.place(),
                     fmt::format("expected {}, found {} items", wanted, node.children.size()));
    return std::nullopt;
  }
  glm::vec3 value(flat.value);
  bool good = true;
  std::size_t next = 0;
  for (int i = 0; i < 3; ++i) {
    if (two && i == flat.axis) continue;
    const auto part = number(node.children[next++]);
    good = good && part.has_value();
    value[i] = static_cast<float>(part.value_or(0.0));
  }
  return good ? std::optional(value) : std::nullopt;
}

std::optional<glm::vec3> ValueReader::color(const Node& node) const {
  if (node.kind != Node::Kind::text) return vector(node);
  const std::optional<glm::vec3> value = colorOf(node.text);
  if (!value) {
    diagnostics_.add(node.place(), node.text.starts_with('#')
                                       ? fmt::format("expected \"#rrggbb\" in hexadecimal digits, found {}",
                                                     inQuotes(node.text))
                                       : fmt::format("unknown colour {}; {}", inQuotes(node.text),
                                                     suggestion(node.text, colorNames())));
    return std::nullopt;
  }
  return glm::clamp(*value, static_cast<float>(range_.min), static_cast<float>(range_.max));
}

std::optional<glm::ivec2> ValueReader::pair(const Node& node) const {
  if (!expect(node, Node::Kind::list, "a list of two whole numbers")) return std::nullopt;
  if (node.children.size() != 2) {
    diagnostics_.add(node.place(), fmt::format("expected a list of two whole numbers, found {} items",
                                               node.children.size()));
    return std::nullopt;
  }
  const auto first = integer(node.children[0]);
  const auto second = integer(node.children[1]);
  if (!first || !second) return std::nullopt;
  return glm::ivec2(*first, *second);
}

std::optional<int> ValueReader::oneOf(const Node& node, std::span<const char* const> names) const {
  const bool isSwitch = Spec{.words = names}.isSwitch();
  if (isSwitch && node.kind == Node::Kind::boolean) return node.boolean ? 1 : 0;
  const auto words = names.subspan(isSwitch ? 2 : 0);
  const std::string expected = !isSwitch           ? "a string"
                               : words.size() == 1 ? fmt::format("true, false or \"{}\"", words[0])
                                                   : "true, false or a word";
  if (!expect(node, Node::Kind::text, expected.c_str())) return std::nullopt;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (node.text == words[i]) return static_cast<int>(names.size() - words.size() + i);
  if (isSwitch && words.size() == 1) {
    diagnostics_.add(node.place(), fmt::format("expected {}, found {}", expected, inQuotes(node.text)));
    return std::nullopt;
  }
  const std::vector<std::string> known(words.begin(), words.end());
  diagnostics_.add(node.place(), fmt::format("unknown {} {}; {}", name_, inQuotes(node.text),
                                             suggestion(node.text, known)));
  return std::nullopt;
}

}  // namespace simreel::scene
