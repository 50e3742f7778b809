#pragma once
#include <span>
#include <string_view>

namespace simreel::serve {

/// File of the page that is built into the program, with its path below src/serve/page/ and its text.
struct PageFile {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const PageFile> pageFiles();

/// Returns the media type for a file name, such as "text/javascript".
[[nodiscard]] const char* mediaType(std::string_view name);

}  // namespace simreel::serve
