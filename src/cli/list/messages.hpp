#pragma once
#include <span>
#include <string_view>

namespace simreel::cli {

/// A common message, with advice for the user.
struct Message {
  std::string_view code;  ///< exit code; "warning" for a warning, which has no exit code
  const char* shown;      ///< the printed message, with capital words in place of names and numbers
  const char* source;     ///< part of the message that occurs in the source code
  const char* cure;
};

/// Returns the messages in ascending order of their exit codes. Warnings are last.
[[nodiscard]] std::span<const Message> messages();

}  // namespace simreel::cli
