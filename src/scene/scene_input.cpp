#include "scene/scene_input.hpp"

#include "scene/as_run.hpp"
#include "scene/load.hpp"

namespace simreel::scene {

Scene SceneInput::load(const Kinds& kinds) const {
  return text ? parseScene(*text, file, overrides, kinds, assets)
              : loadScene(file, overrides, kinds, assets);
}

Scene SceneInput::loadForTest(const Kinds& kinds) const {
  return text ? load(kinds) : loadTestScene(file, overrides, kinds, assets);
}

std::string SceneInput::asRun(const Kinds& kinds) const {
  return text ? textAsRun(*text, file, overrides) : sceneAsRun(file, overrides, kinds);
}

}  // namespace simreel::scene
