#include "sim/text/content.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int digitLimit = 9;

/// Parses the text between the braces of a placeholder.
TextContent::Part numberOf(std::string_view inner) {
  using Number = TextContent::Part::Number;
  TextContent::Part part;
  const std::string shown(inner);
  if (const std::size_t colon = inner.rfind(':'); colon != std::string_view::npos) {
    std::string_view digits = inner.substr(colon + 1);
    part.digits = takeInteger(digits);
    if (!part.digits || !digits.empty() || *part.digits < 0 || *part.digits > digitLimit)
      throw std::invalid_argument(fmt::format(
          "\"{{{}}}\": the colon must be followed by a number of digits, 0 to {}", shown, digitLimit));
    inner = inner.substr(0, colon);
  }
  if (inner == "frame" || inner == "time") {
    part.number = inner == "frame" ? Number::frame : Number::time;
    return part;
  }
  const std::size_t point = inner.rfind('.');
  if (point == std::string_view::npos || point == 0 || point + 1 == inner.size())
    throw std::invalid_argument(
        fmt::format("\"{{{}}}\" is unknown; use {{frame}}, {{time}} or {{OBJECT.QUANTITY}}, or write "
                    "\"{{{{\" for a brace",
                    shown));
  part.number = Number::quantity;
  part.object = inner.substr(0, point);
  part.quantity = inner.substr(point + 1);
  return part;
}

}  // namespace

TextContent::TextContent(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    if (text.substr(i).starts_with("{{") || text.substr(i).starts_with("}}")) {
      plain += text[i];
      i += 2;
    } else if (text[i] == '{') {
      const std::size_t end = text.find('}', i);
      if (end == std::string_view::npos)
        throw std::invalid_argument("a \"{\" is never closed; write \"{{\" for a brace");
      parts_.push_back(numberOf(text.substr(i + 1, end - i - 1)));
      parts_.back().plain = std::move(plain);
      plain.clear();
      i = end + 1;
    } else {
      plain += text[i++];
    }
  }
  if (!plain.empty() || parts_.empty()) parts_.push_back({std::move(plain)});
}

bool TextContent::changes() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const Part& part) { return part.number != Part::Number::none; });
}

std::string TextContent::alphabet() const {
  std::string all = changes() ? "0123456789.-+einfa" : "";
  for (const Part& part : parts_) all += part.plain;
  return all;
}

std::string TextContent::at(long frame, double seconds, const Measured& measured) const {
  std::string text;
  for (const Part& part : parts_) {
    text += part.plain;
    if (part.number == Part::Number::none) continue;
    if (part.number == Part::Number::frame && !part.digits) {
      text += fmt::format("{}", frame);
      continue;
    }
    const double value = part.number == Part::Number::frame  ? static_cast<double>(frame)
                         : part.number == Part::Number::time ? seconds
                                                             : measured(part.object, part.quantity);
    if (part.digits)
      text += fmt::format("{:.{}f}", value + 0.0, *part.digits);
    else if (part.number == Part::Number::time)
      text += fmt::format("{:.2f}", value + 0.0);
    else
      text += fmt::format("{:.6g}", value + 0.0);
  }
  return text;
}

}  // namespace simreel::sim
