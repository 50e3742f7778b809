#pragma once
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// Returns `text` with terminal control characters and invalid UTF-8 replaced by '?'. Each '?' is one
/// column wide, so that a caret on the next line stays aligned.
[[nodiscard]] std::string printable(std::string_view text);

/// Names chosen by a scene appear in file names and in -D paths, so only plain characters are allowed.
inline constexpr const char* plainNamePattern = "^[A-Za-z0-9_-]{1,64}$";
inline constexpr const char* plainNameText = "must be 1 to 64 letters, digits, '-' or '_'";
[[nodiscard]] bool isPlainName(std::string_view name);

/// Returns `text` in double quotes. A very long text is shortened.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// Returns the hint to print after an unknown name: `did you mean "x"?` if a known name is similar, else
/// the list of all known names.
[[nodiscard]] std::string suggestion(std::string_view unknown, std::span<const std::string> names);

/// Splits a camel-case name into lower-case words joined by `between`: "maxDiffRatio" with '-' becomes
/// "max-diff-ratio".
[[nodiscard]] std::string splitCamelCase(std::string_view camelCase, char between);

}  // namespace simreel::scene
