#pragma once
#include <string>
#include <string_view>

namespace simreel::golden {

/// Returns a description if the file is a placeholder or a damaged copy of the real file. It may be a Git
/// LFS pointer, a text with merge conflict marks, or a PNG whose line ends were converted. Such a file must
/// not be overwritten, because the real file exists elsewhere. The description follows the file name in
/// messages and says how to get the real file: "is a Git LFS pointer, not the file itself; fetch that with
/// git lfs pull". Returns an empty text for other files.
[[nodiscard]] std::string placeholderProblem(std::string_view bytes);

/// Advice for damaged files, which messages append after "; ".
inline constexpr const char* restoreIt = "restore it (git checkout -- FILE), do not write it anew";

}  // namespace simreel::golden
