#pragma once
#include <span>
#include <string_view>

namespace simreel::cli {

/// A common message with the advice that goes with it.
struct Message {
  std::string_view code;  ///< exit code; "warning" for a warning, which has none
  const char* shown;      ///< the message as printed, with names and numbers replaced by capital words
  const char* source;     ///< a part of the message as it stands in the source code
  const char* cure;
};

/// Returns the messages by exit code in ascending order, warnings last.
[[nodiscard]] std::span<const Message> messages();

}  // namespace simreel::cli
