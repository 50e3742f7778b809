#include "frame/bench.hpp"

#include "base/error.hpp"
#include "gl/timestamp.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <utility>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

scene::Scene twoSheets() {
  return scene::parseScene(
      R"({"version": 1, "stage": false, "render": {"size": [33, 21], "samples": 1}, "sun": {"shadowSize": 64},
          "objects": {"a": {"cloth": {"size": [9, 7]}}, "b": {"sphere": {}}}})",
      "test.json", {}, sim::kinds());
}

}  // namespace

TEST_CASE("bench: all timing modes record the same frames and stages") {
  const gl::Context& context = testContext();
  for (const frame::Timing timing : {frame::Timing::wait, frame::Timing::query, frame::Timing::whole}) {
    frame::BenchRun run(twoSheets(), context, timing);
    int done = 0;
    const auto count = [&] { return ++done != 14; };
    run.run(3, 5, count);
    CHECK(done == 8);
    run.run(1, 50, count);  // `count` returns false at the sixth frame, which ends the run.
    const frame::FrameTimes& times = run.times();
    CHECK(times.frames.size() == 10);
    CHECK(times.frames.front() == 4);  // frame 0 and three warm-up frames are not measured
    CHECK(times.wall.size() == times.frames.size());
    CHECK(times.stages.empty() == (timing == frame::Timing::whole));
    for (const frame::StageSeries& stage : times.stages) {
      CHECK(stage.cpu.size() == times.frames.size());
      CHECK(stage.gpu.size() == (timing == frame::Timing::query ? times.frames.size() : 0));
    }
    if (timing == frame::Timing::whole) continue;
    CHECK(times.stages[0].name == "step a");
    CHECK(times.stages[1].name == "step b");
    if (timing == frame::Timing::wait)
      for (std::size_t i = 0; i < times.wall.size(); ++i) {
        double spent = 0;
        for (const frame::StageSeries& stage : times.stages) spent += stage.cpu[i];
        CHECK(spent <= times.wall[i]);
      }
  }
}

TEST_CASE("bench: the world calls back after each object's step") {
  testContext();
  const auto scene = twoSheets();
  sim::World world(scene);
  std::vector<std::size_t> stepped;
  world.advanceTo(2, {}, [&](std::size_t object) { stepped.push_back(object); });
  CHECK(stepped == std::vector<std::size_t>{0, 1, 0, 1});
}

TEST_CASE("bench: objects in contact share one step stage") {
  scene::Scene scene = scene::parseScene(
      R"({"version": 1, "objects": {
           "a": {"cloth": {"size": [5, 5], "fabric": {}, "contact": {}}},
           "b": {"cloth": {"size": [5, 5], "position": [0, 0.5, 0]}},
           "c": {"cloth": {"size": [5, 5], "position": [0, 1, 0], "fabric": {}, "contact": {}}}}})",
      "scene.json", {}, sim::kinds());
  frame::BenchRun run(std::move(scene), testContext(), frame::Timing::wait);
  run.run(0, 2, [] { return true; });
  CHECK(run.times().stages[0].name == "step a and 1 more in contact");
  CHECK(run.times().stages[1].name == "step b");
  CHECK(run.times().stages[2].name == "state hash");
}

TEST_CASE("later GPU timestamps are not earlier") {
  testContext();
  gl::Timestamp first;
  gl::Timestamp second;
  first.record();
  glFinish();
  second.record();
  CHECK(second.millisecondsSince(first) >= 0);
  CHECK(first.millisecondsSince(first) == 0);
}
