#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel {

/// Columns for help: $COLUMNS if it is set, else the width of the terminal on standard output, else 100.
/// Always 40 to 200.
[[nodiscard]] std::size_t textWidth();

/// Columns that UTF-8 text takes, one a character.
[[nodiscard]] std::size_t textColumns(std::string_view text);

/// `text` in lines of at most `width` columns, broken at spaces. Each line but the first starts with
/// `indent` spaces; `taken` columns of the first are used already. A longer word keeps a line for itself.
/// Newlines in `text` stay. No newline at the end.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0,
                                  std::size_t taken = 0);

/// One entry of a list for people: `name` two columns in, `text` from `column` on; a name that does not fit
/// has a line of its own. Ends with a newline.
[[nodiscard]] std::string listEntry(std::string_view name, std::string_view text, std::size_t column,
                                    std::size_t width);

}  // namespace simreel
