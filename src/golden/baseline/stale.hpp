#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// What of a scene's baselines (`<scene's folder>/golden/<scene>`) nothing is tested against: frames that
/// are not among `frames`, pictures that no baseline.json lists, and of exact pictures the profiles of
/// drivers. With `remove` it is taken out; what cannot be read or stands for another file
/// (standsForAnother()) is named and stays. Throws UserError(inputOutput) where it cannot be removed.
[[nodiscard]] std::vector<Stale> staleParts(const std::filesystem::path& folder,
                                            std::span<const int> frames, bool exactPictures, bool remove);

/// Folders of baselines, `<folder>/golden/<scene>`, at any depth below these folders, whose scene is not
/// there. Sorted. Throws UserError(inputOutput) for a folder that cannot be listed.
[[nodiscard]] std::vector<std::filesystem::path> baselinesWithoutScene(std::span<const std::string> paths);

/// Removes the files of a baseline and the folders that are empty then. False where something else was in
/// them, which stays. Throws UserError(inputOutput).
bool removeBaselines(const std::filesystem::path& folder);

}  // namespace simreel::golden
