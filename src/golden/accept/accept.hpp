#pragma once
#include "golden/accept/acceptance.hpp"

#include <filesystem>
#include <vector>

namespace simreel::golden {

/// Promotes what a report's run made to baselines, without rendering: the pictures whose pixels the report
/// lists, and the state. Scenes that passed are left out. A scene whose baseline has changed since that
/// run, or whose kept pictures have not the pixels they had, is not promoted. Throws UserError(usage) for a
/// report that cannot be used, also where that is of pictures and names a folder outside of this one. A
/// scene outside of `how.scenes` is not promoted.
[[nodiscard]] std::vector<Accepted> acceptReport(const std::filesystem::path& report,
                                                 const Acceptance& how);

}  // namespace simreel::golden
