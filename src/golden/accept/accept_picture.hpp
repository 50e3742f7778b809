#pragma once
#include "golden/accept/acceptance.hpp"
#include "golden/result.hpp"

#include <filesystem>

namespace simreel::golden {

/// Returns the folder of the picture baselines. This is `how.expected` if it is given, and otherwise the
/// report's folder. The report's folder must be below the current folder, because a report from an
/// untrusted source must not choose which files are written. Throws UserError(usage).
[[nodiscard]] std::filesystem::path expectedFolder(const SuiteResult& suite, const Acceptance& how);

/// Makes the stored picture of a report the baseline. If the picture was renamed, removes the baseline of
/// the former name. If `confined`, refuses to write outside of the current folder, even through links.
[[nodiscard]] Accepted acceptPicture(const std::filesystem::path& reportFolder, const SceneResult& picture,
                                     const std::filesystem::path& expected, bool confined);

}  // namespace simreel::golden
