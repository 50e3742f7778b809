#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::golden {

/// Files below a folder, as sorted relative paths with '/'.
struct PictureFolder {
  std::vector<std::string> pictures;
  /// Files that are not pictures, and folders that are not searched. The paths of folders end in '/'.
  std::vector<std::string> others;
};

/// Marks a folder as part of a report, so that its pictures are not used as baselines. Does nothing if it
/// is already marked.
void markReport(const std::filesystem::path& folder);
[[nodiscard]] bool isReport(const std::filesystem::path& folder);

/// Searches the folder and its subfolders, following links. Skips hidden folders and report folders. Throws
/// UserError(inputOutput) if a folder cannot be listed or links form a cycle.
[[nodiscard]] PictureFolder listPictures(const std::filesystem::path& folder);

/// Returns a list of names, shortened if it is long: "notes.txt, .git/ and 3 more".
[[nodiscard]] std::string someOf(const std::vector<std::string>& names);

}  // namespace simreel::golden
