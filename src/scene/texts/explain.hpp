#pragma once
#include "scene/scene.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace simreel::scene {

/// One value of a scene as it will be used.
struct ExplainedValue {
  std::string path;       ///< as -D takes it: "objects.flag.cloth.size"
  std::string value;      ///< JSON; "off" of a group that is not there
  std::string origin;     ///< "flag.json:12", "-D", "default", "stage", ...
  bool standard = false;  ///< whether it is a plain default
};

/// Every value of a loaded scene, in the order of its declarations. The same file, overrides and kinds that
/// it was loaded with.
[[nodiscard]] std::vector<ExplainedValue> explainScene(Scene& scene, const std::filesystem::path& file,
                                                       std::span<const Override> overrides,
                                                       const Kinds& kinds);

}  // namespace simreel::scene
