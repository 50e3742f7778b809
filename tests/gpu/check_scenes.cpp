// The checks of every shipped scene hold at its test frames.
#include "golden/check.hpp"
#include "gpu/draw_stage.hpp"
#include "sim/list.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <doctest/doctest.h>

using namespace simreel;
namespace fs = std::filesystem;

namespace {

void checkScene(const std::string& name) {
  const fs::path root = SOURCE_FOLDER;
  testContext();
  setenv("SIMREEL_ASSETS", (root / "assets").c_str(), 1);  // NOLINT(concurrency-mt-unsafe): one thread
  const auto scene = scene::loadTestScene(root / "assets/scenes" / (name + ".json"), {}, sim::kinds());
  CHECK(scene.test.frames.size() >= 2);
  CHECK(scene.checks.size() >= 4);
  const std::vector<int> tested = scene.testFrames();
  sim::World world(scene);
  golden::Checker checker(scene, world, tested);
  std::vector<int> frames = checker.frames();
  frames.insert(frames.end(), tested.begin(), tested.end());
  std::sort(frames.begin(), frames.end());
  draw::Renderer renderer(scene, scene.test.size, scene.test.samples.value_or(scene.render.samples));
  draw::Readback readback(scene.test.size);
  for (const int frame : frames) {
    world.advanceTo(frame);
    if (!std::binary_search(tested.begin(), tested.end(), frame)) {
      checker.frame(frame, world, nullptr);
      continue;
    }
    renderer.draw(world.time(), world.drawables());
    readback.start(renderer.target(), frame);
    const frame::Image image{scene.test.size.x, scene.test.size.y, readback.take(true).value().second};
    checker.frame(frame, world, &image);
  }
  CHECK(checker.results().size() >= scene.checks.size());
  for (const golden::CheckResult& result : checker.results()) CHECK_MESSAGE(result.passed, result.message);
}

}  // namespace

TEST_CASE("checks hold: flag") {
  checkScene("flag");
}
TEST_CASE("checks hold: curtain") {
  checkScene("curtain");
}
TEST_CASE("checks hold: tablecloth") {
  checkScene("tablecloth");
}
