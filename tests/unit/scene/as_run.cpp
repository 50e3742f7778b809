#include "scene/as_run.hpp"

#include "base/error.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
namespace fs = std::filesystem;

namespace {

std::string asRun(const std::string& text, const std::vector<std::string>& changes = {}) {
  const simreel::test::TemporaryFile file("scene.json", text);
  std::vector<scene::Override> overrides;
  for (const std::string& change : changes) overrides.push_back(scene::parseOverride(change));
  return scene::sceneAsRun(file.path(), overrides, sim::kinds());
}

}  // namespace

TEST_CASE("scene as run: it is plain JSON that includes the overrides") {
  CHECK(asRun("{\"version\": 1, // so\n \"title\": \"a \\\"b\\\"\", \"time\": {\"fps\": 30}}",
              {"time.fps=0.1", "render.size=[64,36]", "seed=3", "objects.b={\"sphere\":{}}"}) ==
        "{\n  \"version\": 1,\n  \"title\": \"a \\\"b\\\"\",\n  \"time\": {\"fps\": 0.1},\n"
        "  \"render\": {\n    \"size\": [64, 36]\n  },\n  \"seed\": 3,\n  \"objects\": {\n    \"b\": {\n"
        "      \"sphere\": {}\n    }\n  }\n}\n");
  CHECK_THROWS_AS(asRun("{\"version\": 1, }"), UserError);
}

TEST_CASE("scene as run: reading it back gives the same scene, for every shipped scene") {
  const fs::path folder = fs::path(sourceFolder()) / "assets/scenes";
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".test") continue;
    CAPTURE(entry.path().string());
    const std::string text = scene::sceneAsRun(entry.path(), {}, sim::kinds());
    const simreel::test::TemporaryFile file("again.json", text);
    CHECK(scene::sceneAsRun(file.path(), {}, sim::kinds()) == text);
  }
}

TEST_CASE("scene as run: parameters used only for drawing do not change the simulation hash") {
  const std::string text =
      R"({"version": 1, "time": {"fps": 30}, "objects": {"dish": {"grayScott": {"size": [16, 16]}}}})";
  const auto hash = [&](const std::string& change) { return scene::simulationHash(asRun(text, {change})); };
  const std::string plain = scene::simulationHash(asRun(text));
  for (const char* path : {"title=x", "render.size=[64,36]", "render.samples=1", "camera.roll=3",
                           "sun.intensity=2", "sky.ambient=0.5", "time.duration=9",
                           "objects.dish.material.roughness=0.3", "camera.track.offset=[0,1,0]"}) {
    CAPTURE(path);
    CHECK(hash(path) == plain);
    CHECK(!scene::touchesSimulation(std::string(path).substr(0, std::string(path).find('='))));
  }
  for (const char* path :
       {"seed=2", "time.fps=60", "time.start=1", "numerics=fast", "ground={}",
        "objects.dish.grayScott.feed=0.04", "objects.b={\"sphere\":{}}",
        // The lag of a camera behind an object is carried from frame to frame.
        "camera.track={\"object\": \"dish\", \"damping\": 0.5}",
        "camera.follow={\"object\": \"dish\", \"damping\": 0.5}", "camera.damping=0.5"}) {
    CAPTURE(path);
    CHECK(hash(path) != plain);
    CHECK(scene::touchesSimulation(std::string(path).substr(0, std::string(path).find('='))));
  }
}
