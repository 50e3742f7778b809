#pragma once
#include "golden/accept/acceptance.hpp"

#include <filesystem>
#include <vector>

namespace simreel::golden {

/// Promotes the results of a report to baselines without rendering. Promotes the state and the pictures
/// with the pixel hashes of the report. Skips scenes that passed. Does not promote a scene if its baseline
/// has changed since the run, if its stored pictures have other pixels, or if it is outside of
/// `how.scenes`. Throws UserError(usage) if the report is unusable, or if it is about pictures and names a
/// folder outside of the current one.
[[nodiscard]] std::vector<Accepted> acceptReport(const std::filesystem::path& report,
                                                 const Acceptance& how);

}  // namespace simreel::golden
