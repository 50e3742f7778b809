#pragma once
#include <span>
#include <string_view>

namespace simreel::serve {

/// A file of the page built into the program: path below src/serve/page/ and text.
struct PageFile {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const PageFile> pageFiles();

/// "text/javascript" and so on, by the name's ending.
[[nodiscard]] const char* mediaType(std::string_view name);

}  // namespace simreel::serve
