#include "golden/files/damage.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::golden {

namespace {

/// Returns the line number (from 1) of the first merge conflict mark if the text has all three marks, and
/// otherwise 0.
long conflictLine(std::string_view text) {
  const auto lineAt = [&](std::string_view mark, std::size_t from) {
    if (from == 0 && text.starts_with(mark)) return std::size_t{0};
    const auto found = text.find("\n" + std::string(mark), from);
    return found == std::string_view::npos ? found : found + 1;
  };
  const std::size_t ours = lineAt("<<<<<<< ", 0);
  if (ours == std::string_view::npos) return 0;
  const std::size_t middle = lineAt("=======", ours);
  if (middle == std::string_view::npos || lineAt(">>>>>>> ", middle) == std::string_view::npos) return 0;
  return 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(ours), '\n');
}

}  // namespace

std::string placeholderProblem(std::string_view bytes) {
  if (bytes.starts_with("version https://git-lfs.github.com/spec/"))
    return "is a Git LFS pointer, not the file itself; fetch that with git lfs pull";
  // PNG's signature is designed to reveal the conversion of line ends: CR LF became LF, or LF became CR LF.
  if (bytes.starts_with("\x89PNG\n\x1a") || bytes.starts_with("\x89PNG\r\r\n"))
    return "had its line ends converted; mark it as binary in .gitattributes (*.png binary) and restore it";
  constexpr std::size_t longestText = std::size_t{16} << 20;
  if (const long line = conflictLine(bytes.substr(0, longestText)); line > 0)
    return fmt::format(
        "holds a merge conflict (line {}); resolve it, for example with git checkout --theirs FILE", line);
  return {};
}

}  // namespace simreel::golden
