// Tests that a world resumed from a checkpoint continues exactly as if it had not been interrupted.
#include "frame/file/checkpoint.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/file/run_info.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/core/path.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
namespace fs = std::filesystem;

namespace {

constexpr int lastFrame = 500;

frame::RunInfo runOf(const scene::Scene& scene) {
  frame::RunInfo run;
  run.sceneHash = scene.hash;
  run.seed = scene.seed;
  run.numerics = "exact";
  run.fingerprint = "test";
  run.simulation = scene.hash;
  return run;
}

sim::World::Summary summaryAt(sim::World& world, int frame) {
  world.advanceTo(frame);
  world.startSummary();
  return *world.takeSummary(true);
}

std::vector<std::uint8_t> pictureOf(const scene::Scene& scene, const sim::World& world) {
  // Uses the sample count of the scene's "test" member, so that Mesa's cache already holds the shaders.
  draw::Renderer renderer(scene, {96, 54}, scene.test.samples.value_or(scene.render.samples));
  draw::Readback readback({96, 54});
  renderer.draw(world.time(), world.drawables());
  readback.start(renderer.target(), world.frame());
  return readback.nextPicture(true)->second;
}

scene::Scene ofText(const std::string& text) {
  return scene::parseScene(text, "test.json", {}, sim::kinds());
}

/// A wildfire with 20 steps per frame. From frame 52 on, the initial capacity of 1,024 rows is exceeded.
constexpr const char* fire = R"({"version": 1, "objects": {"hill": {"wildfire": {"size": [1997, 53],
  "stepsPerSecond": 1200, "strokes": [{"from": [30, 20, 0], "radius": 4}]}}}})";

}  // namespace

TEST_CASE("checkpoint: shipped scenes of every object kind resume with identical states and pictures") {
  testContext();
  const test::TemporaryFile place("checkpoint", "");
  ::setenv("SIMREEL_ASSETS", (fs::path(sourceFolder()) / "assets").c_str(), 1);
  // Skips the slow scenes. The other scenes cover every kind of object that they contain.
  const std::string longOnes =
      "\n" + readFile(fs::path(sourceFolder()) / "tests/long_scenes.txt", "list") + "\n";
  std::vector<fs::path> scenes;
  for (const auto& entry : fs::directory_iterator(fs::path(sourceFolder()) / "assets/scenes"))
    if (entry.path().extension() == ".json" &&
        longOnes.find("\n" + entry.path().stem().string() + "\n") == std::string::npos)
      scenes.push_back(entry.path());
  std::sort(scenes.begin(), scenes.end());
  REQUIRE(scenes.size() >= 19);
  int changed = 0;
  std::set<std::string> kinds;
  for (const fs::path& file : scenes) {
    CAPTURE(file.filename().string());
    // Starts at time 0 without steps before the first frame, because such steps take seconds.
    std::vector<scene::Override> atOnce = {scene::parseOverride("time.start=0")};
    const std::size_t before = kinds.size();
    for (const scene::Object& object : scene::loadScene(file, {}, sim::kinds()).objects) {
      kinds.insert(object.kind);
      if (object.kind == "grayScott")
        atOnce.push_back(scene::parseOverride("objects." + object.name + ".grayScott.presteps=0"));
    }
    if (kinds.size() == before)
      continue;  // Skips the scene if earlier scenes cover all kinds of objects
                 // in it.
    const scene::Scene scene = scene::loadScene(file, atOnce, sim::kinds());
    sim::World whole(scene);
    const auto at = summaryAt(whole, 1);
    frame::Checkpoint::write(place.path(), runOf(scene), at.stateHash, "rows", whole);

    sim::World resumed(scene);
    const auto checkpoint = frame::Checkpoint::read(place.path(), runOf(scene), lastFrame);
    REQUIRE(checkpoint);
    checkpoint->restore(resumed);
    CHECK(checkpoint->counts() == "rows");
    CHECK(resumed.frame() == 1);
    const auto again = summaryAt(resumed, 1);
    CHECK(again.stateHash == checkpoint->stateHash());
    CHECK(again.counts == at.counts);
    const auto later = summaryAt(whole, 2);
    const auto laterAgain = summaryAt(resumed, 2);
    CHECK(laterAgain.stateHash == later.stateHash);
    CHECK(laterAgain.counts == later.counts);
    CHECK((pictureOf(scene, resumed) == pictureOf(scene, whole)));
    changed += later.stateHash == at.stateHash ? 0 : 1;
  }
  CHECK(kinds.size() >= 15);
  CHECK(changed >= 9);  // The state must change between frames, because equal states would otherwise prove
                        // nothing.
  ::unsetenv("SIMREEL_ASSETS");
}

TEST_CASE(
    "checkpoint: long runs resume identically (count tables, births and deaths, generations, trails, "
    "heights)") {
  testContext();
  const test::TemporaryFile place("checkpoint", "");
  const std::string texts[] = {
      fire,
      // Uses the technique "jobs" on the CPU. The first test case covers the GPU technique.
      R"({"version": 1, "objects": {
        "ball": {"sphere": {"radius": 0.5, "position": {"keys": [[0, [-1, 0.3, 0]], [2, [1, 0.3, 0]]]}}},
        "snow": {"mesh": {"shape": "plane", "size": [4, 0, 4], "resolution": [33, 31],
          "technique": "jobs", "deform": [{"footprints": {}}]}}}})",
      R"({"version": 1, "objects": {"sparks": {"particles": {"acceleration": [0, -9.81, 0],
        "emitters": [{"rate": 300, "lifetime": 0.5}, {"rate": 77, "lifetime": 0.2, "from": 0.3}]}}}})",
      R"({"version": 1, "objects": {"cells": {"life": {"size": [97, 53], "stepsPerSecond": 30,
        "trail": 9, "strokes": [{"at": 0.5, "until": 1.3, "from": [30, 20, 0], "to": [60, 20, 0]}]}}}})",
      R"({"version": 1, "objects": {
        "sea": {"mesh": {"shape": "plane", "size": [4, 0, 4], "resolution": [33, 31], "collides": true,
          "deform": [{"ripple": {"amplitude": 0.2}}]}},
        "rain": {"particles": {"method": "none", "acceleration": [0, -9.81, 0], "collides": true,
          "groups": [{"shape": "cube", "count": 777, "position": [0, 2, 0]}]}}}})",
      R"({"version": 1, "objects": {
        "pond": {"water": {"size": [33, 31], "cell": 0.1, "terrain": {"bed": -0.4}, "collides": true, "rain": {"rate": 40},
          "drops": [{"at": 0.3, "height": 0.3}]}},
        "leaves": {"particles": {"method": "none", "acceleration": [0, -9.81, 0], "collides": true,
          "groups": [{"shape": "cube", "count": 77, "position": [0, 2, 0]}]}}}})",
      R"({"version": 1, "objects": {
        "seen": {"reaction": {"size": [33, 21], "parameters": {"wind": {"field": "air.temperature"}, "fire": {"field": "heath"}, "back": {"field": "feels.u"}},
          "show": "u + wind", "species": {"u": {"rate": "wind + 0.01*fire - back"}}}},
        "feels": {"reaction": {"size": [31, 22], "parameters": {"other": {"field": "seen"}}, "species": {"u": {"diffusion": 0.5, "rate": "other - u"}}}},
        "heath": {"wildfire": {"size": [65, 41], "strokes": [{"from": [20, 20, 0]}]}},
        "air": {"fluid": {"size": [31, 22], "substeps": 1,
          "strokes": [{"until": 9, "radius": 3, "velocity": [25, 0, 0], "from": [9, 9, 0], "temperature": 3}]}}}})",
      R"({"version": 1, "objects": {
        "dust": {"particles": {"method": "none", "wind": {"fluid": "air"}, "groups": [{"shape": "cube", "count": 77}]}},
        "heath": {"wildfire": {"size": [65, 41], "wind": {"fluid": "air"}, "strokes": [{"from": [20, 20, 0]}]}},
        "air": {"fluid": {"size": [31, 22], "substeps": 1, "tracers": {"count": 99, "seconds": 0.5},
          "strokes": [{"until": 9, "radius": 3, "velocity": [25, 0, 0],
            "path": {"keys": [[0, [5, 5, 0]], [2, [20, 15, 0]]]}}]}}}})"};
  for (const std::string& text : texts) {
    CAPTURE(text);
    const scene::Scene scene = ofText(text);
    sim::World whole(scene);
    const auto at = summaryAt(whole, 60);
    frame::Checkpoint::write(place.path(), runOf(scene), at.stateHash, "", whole);
    sim::World resumed(scene);
    frame::Checkpoint::read(place.path(), runOf(scene), lastFrame).value().restore(resumed);
    const auto again = summaryAt(resumed, 60);
    CHECK(again.stateHash == at.stateHash);
    CHECK(again.counts == at.counts);
    const auto later = summaryAt(whole, 90);
    CHECK(later.stateHash != at.stateHash);
    CHECK(summaryAt(resumed, 90).stateHash == later.stateHash);
    CHECK((pictureOf(scene, resumed) == pictureOf(scene, whole)));
  }
}

TEST_CASE("checkpoint: cloth on deforming meshes and on a body resumes identically") {
  testContext();
  const test::TemporaryFile place("checkpoint", "");
  ::setenv("SIMREEL_ASSETS", (fs::path(sourceFolder()) / "assets").c_str(), 1);
  const scene::Scene scene = ofText(R"({"version": 1, "time": {"start": 0.05}, "objects": {
    "sheet": {"cloth": {"size": [9, 8], "spacing": 0.04, "position": [0, 0.03, 0], "fabric": "cotton", "contact": true, "pins": []}},
    "cap": {"cloth": {"size": [9, 8], "spacing": 0.04, "position": [3, 1.82, 0], "fabric": "cotton", "contact": true, "pins": []}},
    "roller": {"sphere": {"radius": 0.1, "collides": true,
                          "position": {"keys": [[0, [-0.3, 0.08, 0.3]], [0.4, [0.3, 0.08, 0.3]]]}}},
    "snow": {"mesh": {"shape": "plane", "size": [1, 0, 1], "resolution": [17, 15], "collides": "faces",
                      "deform": [{"footprints": {}}, {"waves": [{"amplitude": 0.02, "length": 0.4}]}]}},
    "ball": {"mesh": {"shape": "sphere", "radius": 0.06, "resolution": [9, 6], "collides": "faces",
                      "position": {"keys": [[0, [0, -0.1, 0]], [0.2, [0, 0.2, 0]]]},
                      "rotation": {"keys": [[0, [0, 0, 0]], [0.2, [0, 90, 30]]]}}},
    "walker": {"body": {"file": "meshes/walker.gltf", "animation": "walk", "position": [3, 0, 0], "collides": "faces"}}}})");
  sim::World whole(scene);
  const auto at = summaryAt(whole, 5);
  frame::Checkpoint::write(place.path(), runOf(scene), at.stateHash, "", whole);
  sim::World resumed(scene);
  frame::Checkpoint::read(place.path(), runOf(scene), lastFrame).value().restore(resumed);
  const auto later = summaryAt(whole, 9);
  CHECK(later.stateHash != at.stateHash);
  CHECK(summaryAt(resumed, 9).stateHash == later.stateHash);
  sim::World passed(scene);
  passed.advanceUndrawn(8);
  CHECK(summaryAt(passed, 9).stateHash == later.stateHash);
  ::unsetenv("SIMREEL_ASSETS");
}

TEST_CASE("checkpoint: a damaged checkpoint, or one of another run or program version, is ignored") {
  testContext();
  const test::TemporaryFile place("checkpoint", "");
  const scene::Scene scene = ofText(fire);
  const frame::RunInfo run = runOf(scene);
  CHECK(!frame::Checkpoint::read(place.path(), run, lastFrame));
  CHECK(!frame::Checkpoint::read(place.path() / "nowhere", run, lastFrame));
  sim::World world(scene);
  frame::Checkpoint::write(place.path(), run, summaryAt(world, 2).stateHash, "", world);
  CHECK(frame::Checkpoint::read(place.path(), run, lastFrame));
  frame::RunInfo other = run;
  other.simulation = "of other numbers";
  CHECK(!frame::Checkpoint::read(place.path(), other, lastFrame));
  // With fast numerics, the state depends on the driver, so a checkpoint of another driver is rejected.
  frame::RunInfo fast = run;
  fast.numerics = "fast";
  frame::Checkpoint::write(place.path(), fast, "hash", "", world);
  CHECK(frame::Checkpoint::read(place.path(), fast, lastFrame));
  fast.fingerprint = "another driver";
  CHECK(!frame::Checkpoint::read(place.path(), fast, lastFrame));
  frame::Checkpoint::write(place.path(), run, summaryAt(world, 3).stateHash, "", world);
  other = run;
  other.fingerprint = "another driver";
  CHECK(frame::Checkpoint::read(place.path(), other, lastFrame));
  const std::string text = readFile(place.path(), "checkpoint");
  const auto usable = [&](const std::string& changed) {
    std::ofstream(place.path(), std::ios::binary) << changed;
    return frame::Checkpoint::read(place.path(), run, lastFrame).has_value();
  };
  CHECK(usable(text));
  std::string flipped = text;
  flipped[text.size() - 100] ^= 1;
  CHECK(!usable(flipped));
  CHECK(!usable(text.substr(0, text.size() - 1)));
  CHECK(!usable(text + "x"));
  CHECK(!usable(text.substr(0, 40)));
  CHECK(!usable(""));
  CHECK(!usable("{}\n"));
  CHECK(!usable("[1]\n"));
  std::string program = text;
  program.replace(text.find("\"program\":\"") + 11, 1, "9");
  CHECK(!usable(program));

  // Changes numbers in the header, first with the old hash, then with a recomputed hash ("forged").
  const std::string body = text.substr(0, text.size() - 32);
  const auto withNumber = [&](const char* key, const std::string& number, bool forged) {
    const std::size_t begin = body.find(key) + std::string_view(key).size();
    std::string changed = body;
    changed.replace(begin, body.find_first_of(",]", begin) - begin, number);
    return changed + (forged ? hashHex(changed) : text.substr(body.size()));
  };
  CHECK(usable(withNumber("\"frame\":", "3", true)));
  CHECK(usable(withNumber("\"frame\":", "4", true)));
  CHECK(!usable(withNumber("\"frame\":", "4", false)));
  for (const char* frame : {"-1", "501", "4294967298", "18446744073709551615", "2.5", "null"})
    CHECK(!usable(withNumber("\"frame\":", frame, true)));
  for (const char* counts : {"1", "18446744073709551615", "-1"})
    CHECK(!usable(withNumber("\"counts\":", counts, true)));
  // The sizes of the two parts add up to 2^64, which overflows to 0.
  std::string wrapped = body;
  wrapped.insert(wrapped.find("\"parts\":[") + 9,
                 R"(["a","b",9223372036854775808],["a","b",9223372036854775808],)");
  CHECK(!usable(wrapped + hashHex(wrapped)));
}

TEST_CASE("checkpoint: a checkpoint that does not fit its world is refused") {
  testContext();
  const test::TemporaryFile place("checkpoint", "");
  const scene::Scene scene = ofText(fire);
  sim::World world(scene);
  frame::Checkpoint::write(place.path(), runOf(scene), summaryAt(world, 2).stateHash, "", world);
  const auto checkpoint = frame::Checkpoint::read(place.path(), runOf(scene), lastFrame);
  REQUIRE(checkpoint);
  sim::World cloth(ofText(R"({"version": 1, "objects": {"hill": {"cloth": {}}}})"));
  CHECK_THROWS_WITH_AS(checkpoint->restore(cloth), doctest::Contains("does not match the scene"),
                       UserError);
  sim::World none(ofText(R"({"version": 1})"));
  CHECK_THROWS_WITH_AS(checkpoint->restore(none), doctest::Contains("it has more data"), UserError);
}

TEST_CASE("checkpoint: a path camera with damping T lags by T seconds, also after resuming") {
  testContext();
  // The camera path through this open hall runs straight along the hall's length.
  const scene::Scene scene = ofText(R"({"version": 1, "time": {"fps": 20, "duration": 3},
    "camera": {"follow": {"object": "hall", "progress": {"keys": [[0, 0.1], [3, 0.9]], "ease": "linear"},
                          "damping": 0.3}},
    "objects": {"hall": {"cave": {"size": [80, 7], "fill": 0}}}})");
  const auto laggingAt = [](sim::World& world, int frame) {
    world.advanceTo(frame);
    return world.drawables().dampedCamera;
  };
  const test::TemporaryFile place("checkpoint", "");
  sim::World whole(scene), alone(scene), resumed(scene);
  for (int frame = 0; frame < 20; ++frame) CHECK(laggingAt(whole, frame).size() == 2);
  const auto at = summaryAt(whole, 20);
  frame::Checkpoint::write(place.path(), runOf(scene), at.stateHash, "rows", whole);
  frame::Checkpoint::read(place.path(), runOf(scene), lastFrame)->restore(resumed);
  const std::vector<glm::vec3> found = laggingAt(whole, 40);
  CHECK(laggingAt(alone, 40) == found);
  CHECK(laggingAt(resumed, 40) == found);
  const sim::Drawables drawables = whole.drawables();
  const sim::Path* path = sim::pathOf(drawables, "hall");
  REQUIRE(path != nullptr);
  const double seconds = 40 / 20.0;
  const sim::Stand before = sim::standOn(*path->points, *scene.camera.follow, seconds - 0.3);
  const sim::Stand now = sim::standOn(*path->points, *scene.camera.follow, seconds);
  REQUIRE(found.size() == 2);
  CHECK(glm::distance(found[0], before.target) < 0.01F);  // The path bends slightly at its end.
  CHECK(glm::distance(found[1], before.eye) < 1e-3F);
  CHECK(glm::distance(now.eye, before.eye) > 0.25F);
}
