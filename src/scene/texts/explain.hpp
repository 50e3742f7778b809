#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace simreel::scene {

/// One value of a scene, as it takes effect, with its origin.
struct ExplainedValue {
  std::string path;       ///< path of the value as in option -D: "objects.flag.cloth.size"
  std::string value;      ///< value as JSON; "off" for an absent group
  std::string origin;     ///< origin of the value: "flag.json:12", "command line", "default", "stage", ...
  bool standard = false;  ///< true if the value is its plain default
};

/// Returns all values of a loaded scene in the order of their declarations. `file`, `overrides` and `kinds`
/// must be the same as when the scene was loaded.
[[nodiscard]] std::vector<ExplainedValue> explainScene(Scene& scene, const std::filesystem::path& file,
                                                       std::span<const Override> overrides,
                                                       const Kinds& kinds);

}  // namespace simreel::scene
