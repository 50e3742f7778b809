#pragma once
#include "golden/accept/acceptance.hpp"
#include "golden/result.hpp"

#include <filesystem>

namespace simreel::golden {

/// Returns the folder of the picture baselines: `how.expected`, or else the report's folder, which must be
/// below the current folder, because a report from an untrusted place must not choose what is written.
/// Throws UserError(usage).
[[nodiscard]] std::filesystem::path expectedFolder(const SuiteResult& suite, const Acceptance& how);

/// Makes the kept picture of a report the baseline, and removes the baseline that it was renamed from. If
/// `confined`, refuses to write outside of the current folder, also through links.
[[nodiscard]] Accepted acceptPicture(const std::filesystem::path& reportFolder, const SceneResult& picture,
                                     const std::filesystem::path& expected, bool confined);

}  // namespace simreel::golden
