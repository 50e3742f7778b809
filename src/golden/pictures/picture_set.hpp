#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace simreel::golden {

/// A picture to test. `name` is its path relative to both folders.
struct PictureCase {
  std::string name;
  std::filesystem::path expected, actual;  ///< paths of baseline and picture; empty if the file does not
                                           ///< exist
  /// name of a baseline with the same pixels, if the picture has no baseline under its name and the picture
  /// of that baseline no longer exists; `expected` is then the path of that baseline
  std::string renamedFrom;
};

struct PictureSet {
  std::vector<PictureCase> cases;       ///< picture cases, sorted by name
  std::vector<std::string> passedOver;  ///< skipped paths: files that are no pictures, and hidden folders
};

/// Pairs the pictures of two folders by path, and the unpaired ones by pixels. Pairs only names for which
/// `counts` returns true. The argument `made` of `counts` is true if the picture exists, and false if only
/// its baseline exists. Throws the same errors as listPictures().
[[nodiscard]] PictureSet pairPictures(
    const std::filesystem::path& expected, const std::filesystem::path& actual,
    const std::function<bool(const std::string& name, bool made)>& counts);

}  // namespace simreel::golden
