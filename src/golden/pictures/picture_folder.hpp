#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::golden {

/// What is below a folder, as paths relative to it with '/', sorted.
struct PictureFolder {
  std::vector<std::string> pictures;
  /// Files that are no pictures, and folders that are not entered, which end in '/'.
  std::vector<std::string> others;
};

/// Marks a folder whose pictures are those of a report, and no baselines; nothing where it is marked.
void markReport(const std::filesystem::path& folder);
[[nodiscard]] bool isReport(const std::filesystem::path& folder);

/// Searches the folder and all below it, links included; hidden folders and those of reports are not
/// entered. Throws UserError(inputOutput) for a folder that cannot be listed, and where links go round in a
/// circle.
[[nodiscard]] PictureFolder listPictures(const std::filesystem::path& folder);

/// "notes.txt, .git/ and 3 more"
[[nodiscard]] std::string someOf(const std::vector<std::string>& names);

}  // namespace simreel::golden
