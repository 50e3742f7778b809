#pragma once
#include <string>
#include <vector>

namespace simreel {

/// Replaces one value of a scene, as -D does.
struct Change {
  std::string path;   ///< dotted path, such as "objects.flag.cloth.fabric"
  std::string value;  ///< value as JSON; a word without quotes is a string
};

/// Options for reading a scene.
struct LoadOptions {
  std::vector<Change> changes = {};
  std::vector<std::string> assets = {};  ///< additional folders from which the scene may read files
  /// True to make the layers "velocity" and "vector" available, which cost time in each frame.
  bool motion = false;
};

}  // namespace simreel
