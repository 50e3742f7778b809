#include "scene/scene_source.hpp"

#include "base/file.hpp"
#include "scene/json/json_node.hpp"

namespace simreel::scene {

std::pair<std::string, std::filesystem::path> readSceneSource(const std::filesystem::path& file,
                                                              const Kinds& kinds) {
  if (file == "-") return {standardInput("scene", maxSceneBytes), "<stdin>"};
  for (const Kind& kind : kinds.list)
    if (kind.sceneAround)
      if (std::string text = kind.sceneAround(file); !text.empty()) return {std::move(text), file};
  return {readFile(file, "scene", maxSceneBytes), file};
}

}  // namespace simreel::scene
