#pragma once
#include <string>
#include <string_view>

namespace simreel::golden {

/// What a file is that stands where another should be, and how to get that, to follow its name: "is a Git
/// LFS pointer, not the file itself; fetch it with git lfs pull". Such a file must not be written anew:
/// what it stands for exists. Empty where it is none of these: a Git LFS pointer, a text with the marks of
/// a merge conflict, a PNG whose line ends were converted.
[[nodiscard]] std::string standsForAnother(std::string_view bytes);

/// How to get back what was damaged, to follow "; ".
inline constexpr const char* restoreIt = "restore it (git checkout -- FILE), do not write it anew";

}  // namespace simreel::golden
