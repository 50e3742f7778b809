#pragma once
#include <span>
#include <string_view>

namespace simreel::cli {

/// A message that users meet often.
struct Message {
  std::string_view code;  ///< exit code; "warning": none
  const char* shown;      ///< as it is printed, with capital words for names and numbers
  const char* source;     ///< a part of it as the source code has it
  const char* cure;
};

/// By exit code, in ascending order; warnings last.
[[nodiscard]] std::span<const Message> messages();

}  // namespace simreel::cli
