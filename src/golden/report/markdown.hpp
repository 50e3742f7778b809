#pragma once
#include "golden/result.hpp"

#include <functional>
#include <string>

namespace simreel::golden {

/// Callback that returns the src attribute of an image for a picture path of the report. If the result is
/// empty, the picture is omitted.
using PictureAddress = std::function<std::string(const std::string& picture)>;
inline constexpr int thumbnailWidth = 160;  ///< width of thumbnails in pixels

/// Returns a Markdown summary for a job summary, a comment or a file, below 1 MB (GitHub drops summaries
/// above 1 MiB). If scenes or pictures do not fit, the summary says how many are missing.
[[nodiscard]] std::string markdownSummary(const SuiteResult& suite, const PictureAddress& address = {});

}  // namespace simreel::golden
