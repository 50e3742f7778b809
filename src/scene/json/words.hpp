#pragma once
#include <span>
#include <string>
#include <string_view>

namespace simreel::scene {

/// `text` with what steers terminals and broken UTF-8 replaced by '?', each one column wide, so that a
/// caret below it stands right.
[[nodiscard]] std::string printable(std::string_view text);

/// Names that a scene chooses appear in file names and in -D paths, so they are kept plain.
inline constexpr const char* plainNamePattern = "^[A-Za-z0-9_-]{1,64}$";
inline constexpr const char* plainNameText = "must be 1 to 64 letters, digits, '-' or '_'";
[[nodiscard]] bool isPlainName(std::string_view name);

/// `text` in double quotes, shortened when very long.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// What to say after an unknown name: `did you mean "x"?` when one name is close, else the list of them.
[[nodiscard]] std::string suggestion(std::string_view unknown, std::span<const std::string> names);

/// The words of a name in camel case, in small letters and with `between` between them: "maxDiffRatio", '-'
/// is "max-diff-ratio".
[[nodiscard]] std::string apart(std::string_view camelCase, char between);

}  // namespace simreel::scene
