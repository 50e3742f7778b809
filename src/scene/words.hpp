#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// Bytes of the UTF-8 code point at `at`, 1 to 4; 0 when the bytes there are not valid UTF-8.
[[nodiscard]] std::size_t codePointLength(std::string_view text, std::size_t at);

/// Whether all of `text` is valid UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

/// `text` with control characters and broken UTF-8 replaced by '?', so that printing a hostile scene
/// cannot steer the terminal.
[[nodiscard]] std::string printable(std::string_view text);

/// `text` in double quotes, shortened when very long.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// What to say after an unknown name: `did you mean "x"?` when one name is close, else the list of them.
[[nodiscard]] std::string suggestion(std::string_view unknown, std::span<const std::string> names);

}  // namespace simreel::scene
