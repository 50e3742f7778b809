#pragma once
#include "golden/result.hpp"

#include <functional>
#include <string>

namespace simreel::golden {

/// The src of an image: of a picture's path in the report, its address; empty: it is left out.
using PictureAddress = std::function<std::string(const std::string& picture)>;
inline constexpr int thumbnailWidth = 160;  ///< pixels

/// Markdown for a job summary, a comment or a file, below 1 MB (GitHub drops one above 1 MiB): where scenes
/// or pictures had to be left out it says how many.
[[nodiscard]] std::string markdownSummary(const SuiteResult& suite, const PictureAddress& address = {});

}  // namespace simreel::golden
