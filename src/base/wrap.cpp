#include "base/wrap.hpp"

#include <algorithm>
#include <cstdlib>
#include <sys/ioctl.h>
#include <unistd.h>

namespace simreel {

std::size_t textWidth() {
  constexpr std::size_t minimum = 40, maximum = 200, elsewhere = 100;
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  if (const char* columns = std::getenv("COLUMNS"))
    if (const unsigned long wanted = std::strtoul(columns, nullptr, 10); wanted > 0)
      return std::clamp<std::size_t>(wanted, minimum, maximum);
  winsize size{};
  if (::isatty(STDOUT_FILENO) != 0 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return std::clamp<std::size_t>(size.ws_col, minimum, maximum);
  return elsewhere;
}

std::size_t textColumns(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent, std::size_t taken) {
  std::string out;
  std::size_t column = taken;
  bool lineIsEmpty = true;
  const auto breakLine = [&] {
    out += "\n" + std::string(indent, ' ');
    column = indent;
    lineIsEmpty = true;
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string_view word = text.substr(0, end);
    if (!word.empty()) {
      const std::size_t columns = textColumns(word);
      if (!lineIsEmpty && column + 1 + columns > width) breakLine();
      if (!lineIsEmpty) {
        out += ' ';
        ++column;
      }
      out += word;
      column += columns;
      lineIsEmpty = false;
    }
    if (end == text.size()) break;
    if (text[end] == '\n') breakLine();
    text.remove_prefix(end + 1);
  }
  return out;
}

std::string listEntry(std::string_view name, std::string_view text, std::size_t column, std::size_t width) {
  std::string out = "  " + std::string(name);
  const std::size_t used = 2 + textColumns(name);
  if (text.empty()) return out + "\n";
  out += used + 2 > column ? "\n" + std::string(column, ' ') : std::string(column - used, ' ');
  return out + wrapped(text, width, column, column) + "\n";
}

}  // namespace simreel
