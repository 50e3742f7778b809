#include "base/error.hpp"

#include "base/text.hpp"

#include <cstddef>
#include <cstdlib>

namespace simreel {

namespace {

std::string withoutZeros(std::string text) {
  for (std::size_t at = text.find('\0'); at != std::string::npos; at = text.find('\0', at))
    text.replace(at, 1, "\\x00");
  return text;
}

}  // namespace

UserError::UserError(ExitCode code, const std::string& message, Form form)
    : std::runtime_error(withoutZeros(message)), code_(code), form_(form) {}

void brokenInvariant(const char* file, int line, const char* what, const std::string& values) {
  fmt::print(stderr, "simreel: internal error at {}:{}: {} does not hold: {}\n", file, line, what,
             oneLine(values));
  std::abort();
}

}  // namespace simreel
