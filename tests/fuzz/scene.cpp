#include "scene/scene.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"

namespace simreel::fuzz {
namespace {

void readScene(std::string_view bytes) {
  const scene::Scene scene = scene::parseScene(bytes, "fuzz.json", {}, sim::kinds());
  SIMREEL_CHECK(scene.frameCount() >= 1);
  for (const scene::Object& object : scene.objects) SIMREEL_CHECK(object.parameters != nullptr);
  for (const int frame : scene.testFrames()) SIMREEL_CHECK(frame >= 0 && frame < scene.frameCount());
}

const Reader sceneReader("scene", readScene);

}  // namespace
}  // namespace simreel::fuzz
