#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel {

/// Returns the width of help texts in columns. This is $COLUMNS if it is set, otherwise the width of the
/// terminal on standard output, and otherwise 100. The result is always 40 to 200.
[[nodiscard]] std::size_t textWidth();

/// Returns the width of UTF-8 text in columns, one per code point.
[[nodiscard]] std::size_t textColumns(std::string_view text);

/// Returns `text` in lines of at most `width` columns, broken at spaces. All lines except the first start
/// with `indent` spaces. The first `taken` columns of the first line are already in use. A word that is too
/// long gets its own line. Newlines in `text` remain. There is no newline at the end.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0,
                                  std::size_t taken = 0);

/// Returns one entry of a printed list, with `name` indented by two columns and `text` starting at
/// `column`. A name that does not fit gets a separate line. The entry ends with a newline.
[[nodiscard]] std::string listEntry(std::string_view name, std::string_view text, std::size_t column,
                                    std::size_t width);

}  // namespace simreel
