#pragma once
#include "golden/accept/acceptance.hpp"
#include "golden/result.hpp"

#include <filesystem>

namespace simreel::golden {

/// The folder of the baselines: the one given, else the report's, which has to be below this folder,
/// because a report from elsewhere must not choose what is written. Throws UserError(usage).
[[nodiscard]] std::filesystem::path expectedFolder(const SuiteResult& suite, const Acceptance& how);

/// Makes a picture that a report kept the baseline, and removes the one it was renamed from. `confined`: it
/// may not go out of the current folder, not by links either.
[[nodiscard]] Accepted acceptPicture(const std::filesystem::path& reportFolder, const SceneResult& picture,
                                     const std::filesystem::path& expected, bool confined);

}  // namespace simreel::golden
