#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Finds the parts of a scene's baselines (`<scene's folder>/golden/<scene>`) that no test uses. These are
/// frames not in `frames`, pictures that no baseline.json lists, and driver profiles if pictures are exact.
/// If `remove` is true, also deletes them. Files that are unreadable, Git LFS pointers or in merge conflict
/// (placeholderProblem()) are reported but kept. Throws UserError(inputOutput) if removing fails.
[[nodiscard]] std::vector<Stale> staleParts(const std::filesystem::path& folder,
                                            std::span<const int> frames, bool exactPictures, bool remove);

/// Returns the baseline folders without a scene, sorted. These are the folders `<folder>/golden/<scene>` at
/// any depth below `paths` whose scene does not exist. Throws UserError(inputOutput) if a folder cannot be
/// listed.
[[nodiscard]] std::vector<std::filesystem::path> baselinesWithoutScene(std::span<const std::string> paths);

/// Removes the files of a baseline and then the folders that are empty. Keeps other files, and returns
/// false if there are any. Throws UserError(inputOutput).
bool removeBaselines(const std::filesystem::path& folder);

}  // namespace simreel::golden
