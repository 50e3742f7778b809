#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <system_error>

#include <fmt/format.h>

namespace simreel {

namespace {

std::string speltOut(std::string_view character, bool valid) {
  if (character == "\n") return "\\n";
  if (character == "\r") return "\\r";
  if (character == "\t") return "\\t";
  const auto lead = static_cast<unsigned char>(character[0]);
  if (!valid || character.size() == 1) return fmt::format("\\x{:02x}", lead);
  return fmt::format("\\u{:04x}", static_cast<unsigned>(codePoint(character)));
}

std::string spelt(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = codePointLength(text, at);
    const std::string_view character = text.substr(at, std::max<std::size_t>(length, 1));
    const bool plain = length != 0 && (!isTerminalControl(character) || kept.find(character) != kept.npos);
    out += plain ? std::string(character) : speltOut(character, length != 0);
    at += character.size();
  }
  return out;
}

}  // namespace

std::optional<int> takeInteger(std::string_view& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

std::optional<std::pair<int, int>> integerPair(std::string_view text, char separator) {
  const auto first = takeInteger(text);
  if (!first || !text.starts_with(separator)) return std::nullopt;
  text.remove_prefix(1);
  const auto second = takeInteger(text);
  if (!second || !text.empty()) return std::nullopt;
  return std::pair(*first, *second);
}

std::size_t codePointLength(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U;
  };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if ((first & 0xF0U) == 0xE0U) {
    // Overlong encodings and halves of surrogate pairs are rejected.
    const bool good = (first != 0xE0 || byte(1) >= 0xA0) && (first != 0xED || byte(1) <= 0x9F);
    return good && follows(1) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool good = (first != 0xF0 || byte(1) >= 0x90) && (first != 0xF4 || byte(1) <= 0x8F);
    return good && follows(1) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

char32_t codePoint(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  char32_t code = character.size() == 1   ? lead
                  : character.size() == 2 ? lead & 0x1FU
                  : character.size() == 3 ? lead & 0x0FU
                                          : lead & 0x07U;
  for (const char c : character.substr(1)) code = code << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  return code;
}

bool isUtf8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = codePointLength(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

bool isTerminalControl(std::string_view character) {
  const char32_t code = codePoint(character);
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x061C || code == 0x200E ||
         code == 0x200F || (code >= 0x2028 && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string oneLine(std::string_view text) {
  return spelt(text, "");
}

std::string severalLines(std::string_view text) {
  return spelt(text, "\n\t");
}

std::string withoutCommands(std::string_view text) {
  std::string out;
  for (bool lineBegins = true; !text.empty(); text.remove_prefix(1)) {
    if (lineBegins && text.starts_with("::")) {
      out += ": ";
    } else if (text.starts_with("##[")) {
      out += "# ";
    } else {
      out += text.front();
    }
    // Blanks may precede a command, so the start of the line lasts until the first other character.
    lineBegins = text.front() == '\n' || (lineBegins && (text.front() == ' ' || text.front() == '\t'));
  }
  return out;
}

}  // namespace simreel
