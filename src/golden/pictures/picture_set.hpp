#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace simreel::golden {

/// A picture to test. `name` is its path below both folders.
struct PictureCase {
  std::string name;
  std::filesystem::path expected, actual;  ///< empty: not there
  /// Name of a baseline without a picture that has this picture's pixels, where this one has no baseline;
  /// `expected` is that baseline then.
  std::string renamedFrom;
};

struct PictureSet {
  std::vector<PictureCase> cases;       ///< by name
  std::vector<std::string> passedOver;  ///< files that are no pictures, hidden folders
};

/// Pairs the pictures of two folders by path, and those left over by their pixels: of the names that
/// `counts` takes, asked with whether there is a picture and not only a baseline. Throws as listPictures()
/// does.
[[nodiscard]] PictureSet pairPictures(
    const std::filesystem::path& expected, const std::filesystem::path& actual,
    const std::function<bool(const std::string& name, bool made)>& counts);

}  // namespace simreel::golden
