// Tests "test" and "checks" of a scene and of its sidecar.
#include "scene/load.hpp"
#include "unit/scene/toy.hpp"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <doctest/doctest.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;
using simreel::test::checkHas;
namespace fs = std::filesystem;

namespace {

/// Returns a scene of 120 frames with one object "flag" and these members.
std::string sceneWith(const std::string& members) {
  return "{\"version\": 1, \"objects\": {\"flag\": {\"cloth\": {}}},\n" + members + "}";
}

std::string checkMistakes(const std::string& check, const std::vector<std::string>& changes = {}) {
  return mistakes(sceneWith("\"checks\": [\n{" + check + "}]"), changes);
}

/// Creates a scene, and a sidecar if there is text for it, in a new folder. Removes the files in the
/// destructor.
class Files {
 public:
  Files() : root(fs::temp_directory_path() / ("simreel-sidecar-" + std::to_string(::getpid()))) {
    fs::create_directories(root);
  }
  ~Files() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  void write(const std::string& name, const std::string& text) const { std::ofstream(root / name) << text; }
  [[nodiscard]] Scene load(const std::vector<std::string>& changes = {}) const {
    std::vector<Override> overrides;
    for (const std::string& change : changes) overrides.push_back(parseOverride(change));
    return loadTestScene(root / "flag.json", overrides, toyKinds());
  }
  [[nodiscard]] std::string errors(const std::vector<std::string>& changes = {}) const {
    try {
      static_cast<void>(load(changes));
      return "";
    } catch (const simreel::UserError& error) {
      return error.what();
    }
  }

  fs::path root;
};

}  // namespace

TEST_CASE("test settings with every member are read") {
  const Scene scene = parse(sceneWith(R"("test": {"frames": [0, 60, 119], "size": [64, 36], "samples": 1,
    "tolerance": {"maxChannelDiff": 3, "maxDiffPixels": 20, "maxDiffRatio": 0.25, "windowSize": 8,
                  "maxWindowRatio": 0.5, "maxFlipMean": 0.125, "hardFail": 200},
    "xfail": "the hem flickers"})"));
  CHECK(scene.test.frames == std::vector<int>{0, 60, 119});
  CHECK(scene.testFrames() == std::vector<int>{0, 60, 119});
  CHECK(scene.test.size == glm::ivec2(64, 36));
  CHECK(scene.test.samples == 1);
  const Tolerance& tolerance = scene.test.tolerance;
  CHECK(tolerance.maxChannelDiff == 3);
  CHECK(tolerance.maxDiffPixels == 20.0);
  CHECK(tolerance.maxDiffRatio == 0.25);
  CHECK(tolerance.windowSize == 8);
  CHECK(tolerance.maxWindowRatio == 0.5);
  CHECK(tolerance.maxFlipMean == 0.125);
  CHECK(tolerance.hardFail == 200.0);
  CHECK(scene.test.xfail == "the hem flickers");
  CHECK(scene.test.toleranceOrigin.size() == 7);
  CHECK(scene.test.toleranceOrigin.at("hardFail") == "s.json");
}

TEST_CASE("bounds are also read by their old names, but not by both") {
  const Scene scene = parse(sceneWith(R"("test": {"tolerance": {"max_channel_diff": 3, "hard_fail": 200}},
    "checks": [{"what": "mass", "least": 1, "most": 2}])"),
                            {"test.tolerance.max_diff_ratio=0.5"});
  CHECK(scene.test.tolerance.maxChannelDiff == 3);
  CHECK(scene.test.tolerance.hardFail == 200.0);
  CHECK(scene.test.tolerance.maxDiffRatio == 0.5);
  CHECK(scene.test.toleranceOrigin.size() == 3);
  CHECK(scene.test.toleranceOrigin.at("maxChannelDiff") == "s.json");
  CHECK(scene.test.toleranceOrigin.at("maxDiffRatio") == "-D");
  CHECK(scene.checks[0].min == 1.0);
  CHECK(scene.checks[0].max == 2.0);
  CHECK(has(mistakes(sceneWith(R"("test": {"tolerance": {"hard_fail": 300}})")), "found 300"));
  CHECK(has(mistakes(sceneWith(R"("test": {"tolerance": {"hard_fail": 30, "hardFail": 30}})")),
            "unknown key \"hard_fail\"; did you mean \"hardFail\"?"));
  CHECK(has(checkMistakes(R"("what": "mass", "least": 2, "most": 1)"), "s.json:3:27: error: \"min\" (2)"));
}

TEST_CASE("omitted test settings have their defaults") {
  const Scene scene = parse(sceneWith(R"("title": "t")"));
  CHECK(scene.test.frames.empty());
  CHECK(scene.test.size == glm::ivec2(320, 180));
  CHECK(!scene.test.samples);
  CHECK(scene.test.tolerance.maxChannelDiff == 12);
  CHECK(!scene.test.tolerance.maxDiffRatio);
  CHECK(!scene.test.tolerance.hardFail);
  CHECK(scene.test.toleranceOrigin.empty());
  CHECK(scene.checks.empty());
  CHECK(!parse(sceneWith(R"("test": {"samples": "scene"})")).test.samples);
}

TEST_CASE("omitted test frames are the first, middle and last frame without repeats") {
  const auto framesOf = [](const char* duration) {
    return parse(sceneWith("\"seed\": 1"),
                 {std::string("time.fps=1"), std::string("time.duration=") + duration})
        .testFrames();
  };
  CHECK(framesOf("120") == std::vector<int>{0, 59, 119});
  CHECK(framesOf("3") == std::vector<int>{0, 1, 2});
  CHECK(framesOf("2") == std::vector<int>{0, 1});
  CHECK(framesOf("1") == std::vector<int>{0});
}

TEST_CASE("errors in test settings are reported") {
  const auto says = [](const char* members, const char* message) {
    const std::string report = mistakes(sceneWith("\"test\": {" + std::string(members) + "}"));
    INFO(report);
    return has(report, message);
  };
  CHECK(says(R"("frames": [0, 120])",
             "s.json:2:20: error: frame 120 is beyond the scene's last frame, 119\n"));
  CHECK(says(R"("frames": [0, 9, 9])", "frame 9 is listed twice"));
  CHECK(says(R"("frames": [9, 0])", "frames must ascend; 0 follows 9"));
  CHECK(says(R"("frames": [-1])", "\"frames\" must be between 0 and 10000000, found -1"));
  CHECK(says(R"("xfail": "")", "s.json:2:19: error: \"xfail\" needs a reason"));
  CHECK(says(R"("xfail": "  ")", "\"xfail\" needs a reason"));
  CHECK(says(R"("samples": "all")", "expected a whole number or \"scene\", found \"all\""));
  CHECK(says(R"("size": [320])", "expected a list of two whole numbers"));
  CHECK(says(R"("tolerance": {"max_channel_dif": 3})", "did you mean \"maxChannelDiff\"?"));
  CHECK(says(R"("tolerance": {"maxChannelDiff": 256})", "must be between 0 and 255, found 256"));
  CHECK(says(R"("tolerance": {"maxDiffRatio": 2})", "must be between 0 and 1, found 2"));
  CHECK(says(R"("tolerance": {"hardFail": "x"})", "expected a number, found a string"));
  CHECK(
      says(R"("tolerance": {"windowSize": 8})", "\"windowSize\" does nothing without \"maxWindowRatio\""));
  CHECK(says(R"("frame": [0])", "unknown key \"frame\"; did you mean \"frames\"?"));
  CHECK(!says(R"("frames": [0, 119])", "error"));
}

TEST_CASE("an invalid duration causes no follow-up errors about frames") {
  const std::string report = mistakes(sceneWith(R"("time": {"duration": "x"}, "test": {"frames": [500]})"));
  CHECK(has(report, "expected a number, found a string"));
  CHECK(!has(report, "beyond"));
}

TEST_CASE("an override that shortens a scene does not stop rendering") {
  const std::string scene = sceneWith(R"("test": {"frames": [0, 119]}, "checks": [{"what": "no-nan"}])");
  CHECK(mistakes(scene, {"time.duration=1"}).empty());
  CHECK(mistakes(scene, {"time={\"fps\": 30}"}).empty());
  CHECK(has(mistakes(scene, {"test.frames=[120]"}), "-D test.frames=[120]: error: frame 120 is beyond"));
}

TEST_CASE("checks with every member are read") {
  const Scene scene =
      parse(sceneWith(R"("checks": [{"what": "not-blank"}, {"what": "no-nan", "object": "flag"},
    {"what": "max", "object": "flag", "of": "positions.length", "frames": [3, 7], "min": -1, "max": 2.5},
    {"what": "energy", "drift": 0.5}])"));
  REQUIRE(scene.checks.size() == 4);
  CHECK(scene.checks[0].what == "not-blank");
  CHECK(scene.checks[1].object == "flag");
  CHECK(scene.checks[2].isStatistic());
  CHECK(scene.checks[2].of == "positions.length");
  CHECK(scene.checks[2].frames == std::vector<int>{3, 7});
  CHECK(scene.checks[2].min == -1.0);
  CHECK(scene.checks[2].max == 2.5);
  CHECK(!scene.checks[2].drift);
  CHECK(!scene.checks[3].isStatistic());
  CHECK(scene.checks[3].drift == 0.5);
}

TEST_CASE("errors in checks are reported") {
  const auto says = [](const char* check, const char* message) {
    const std::string report = checkMistakes(check);
    INFO(report);
    return has(report, message);
  };
  CHECK(says(R"("max": 1)", "s.json:3:1: error: \"what\" is missing"));
  CHECK(says(R"("what": "")", "s.json:3:10: error: \"what\" is missing"));
  CHECK(says(R"("what": "min", "min": 0)", "\"min\" needs \"of\""));
  CHECK(says(R"("what": "min", "of": "positions", "min": 0)",
             "s.json:3:23: error: \"positions\" is not a state array and component"));
  CHECK(says(R"("what": "min", "of": "positions.q", "min": 0)", "not a state array and component"));
  CHECK(says(R"("what": "min", "of": "positions.xy", "min": 0)", "not a state array and component"));
  CHECK(says(R"("what": "min", "of": ".y", "min": 0)", "not a state array and component"));
  CHECK(says(R"("what": "energy", "of": "positions.y", "min": 0)",
             "\"of\" belongs to mean, min, max and sum, not to \"energy\""));
  CHECK(says(R"("what": "no-nan", "of": "positions.y")", "not to \"no-nan\""));
  CHECK(says(R"("what": "energy")", "s.json:3:10: error: \"energy\" needs a bound"));
  CHECK(says(R"("what": "sum", "of": "positions.y")", "\"sum\" needs a bound"));
  CHECK(says(R"("what": "not_blank")",
             "needs a bound: \"min\", \"max\" or \"drift\"; did you mean "
             "\"not-blank\"?"));
  CHECK(says(R"("what": "not-blank", "min": 1)", "s.json:3:30: error: \"not-blank\" takes no bounds"));
  CHECK(says(R"("what": "no-nan", "drift": 1)", "\"no-nan\" takes no bounds"));
  CHECK(says(R"("what": "not-blank", "object": "flag")", "looks at the whole picture"));
  CHECK(says(R"("what": "mass", "min": 2, "max": 1)",
             "s.json:3:25: error: \"min\" (2) must not be above \"max\" (1)"));
  CHECK(says(R"("what": "mass", "drift": -1)", "\"drift\" must be at least 0, found -1"));
  CHECK(says(R"("what": "mass", "drift": 1, "frames": [5])", "\"frames\" lists one only"));
  CHECK(says(R"("what": "mass", "max": 1, "frames": [5, 5])", "frame 5 is listed twice"));
  CHECK(says(R"("what": "mass", "max": 1, "frames": [5, 4])", "frames must ascend; 4 follows 5"));
  CHECK(says(R"("what": "mass", "max": 1, "frames": [120])", "frame 120 is beyond the scene's last"));
  CHECK(says(R"("what": "mass", "max": 1, "object": "flga")",
             "no object is named \"flga\"; did you mean \"flag\"?"));
  CHECK(says(R"("what": "not-blank", "frames": [0, 3])", "frame 3 is not a tested frame"));
  CHECK(says(R"("waht": "mass")", "unknown key \"waht\"; did you mean \"what\"?"));
  CHECK(!says(R"("what": "not-blank", "frames": [0, 59])", "error"));
  CHECK(!says(R"("what": "mass", "min": 1, "max": 1)", "error"));
  CHECK(!says(R"("what": "mass", "drift": 0, "frames": [5, 6])", "error"));
}

TEST_CASE("checks of unknown quantities are refused") {
  const auto says = [](const std::string& objects, const std::string& check) {
    return mistakes("{\"version\": 1, \"objects\": {" + objects + "},\n\"checks\": [{" + check + "}]}");
  };
  const char* flag = R"("flag": {"cloth": {}}, "ball": {"capsule": {}})";
  checkHas(says(flag, R"("what": "enrgy", "max": 1)"),
           "s.json:2:21: error: no object of the scene has a quantity \"enrgy\"; did you mean \"energy\"?");
  checkHas(says(flag, R"("what": "infected", "max": 1, "object": "flag")"),
           "object \"flag\" is a cloth and has no quantity \"infected\"; known here: mass, energy");
  checkHas(says(flag, R"("what": "mass", "max": 1, "object": "ball")"),
           "object \"ball\" is a capsule and has no quantity \"mass\"; nothing is known here");
  const char* two = R"("a": {"cloth": {}}, "b": {"cloth": {}})";
  checkHas(says(two, R"("what": "mass", "max": 1)"),
           "several objects have \"mass\": a, b; name one of them with \"object\"");
  CHECK(says(two, R"("what": "mass", "max": 1, "object": "b")").empty());
  // An unknown object must cause only one message.
  CHECK(!has(says(flag, R"("what": "mass", "max": 1, "object": "flga")"), "quantity"));
  CHECK(!has(says(R"("a": {"cloht": {}})", R"("what": "enrgy", "max": 1)"), "quantity"));
}

TEST_CASE("drift needs a second frame; tested frames count") {
  const std::string report =
      mistakes(sceneWith(R"("test": {"frames": [3]}, "checks": [{"what": "mass", "drift": 1}])"));
  CHECK(has(report, "the scene tests one frame only"));
}

TEST_CASE("the sidecar's members replace the scene's members completely") {
  const Files files;
  files.write("flag.json", sceneWith(R"("test": {"frames": [5], "tolerance": {"hardFail": 9}},
                                        "checks": [{"what": "no-nan"}])"));
  CHECK(sidecarOf("a/flag.json") == "a/flag.test.json");
  CHECK(files.load().test.frames == std::vector<int>{5});
  CHECK(files.load().test.toleranceOrigin.at("hardFail") == (files.root / "flag.json").string());

  files.write("flag.test.json", R"({"test": {"size": [8, 8], "tolerance": {"maxDiffRatio": 0.5}}})");
  const Scene scene = files.load();
  CHECK(scene.test.frames.empty());  // The sidecar's "test" replaces the scene's "test" without merging.
  CHECK(!scene.test.tolerance.hardFail);
  CHECK(scene.test.size == glm::ivec2(8, 8));
  CHECK(scene.checks.size() == 1);  // The scene's checks remain, because the sidecar has none.
  REQUIRE(scene.test.toleranceOrigin.size() == 1);
  CHECK(scene.test.toleranceOrigin.at("maxDiffRatio") == (files.root / "flag.test.json").string());
  CHECK(scene.hash == loadScene(files.root / "flag.json", {}, toyKinds()).hash);
  CHECK(loadScene(files.root / "flag.json", {}, toyKinds()).test.frames == std::vector<int>{5});

  const Scene changed = files.load({"test.tolerance.maxDiffRatio=0.25"});
  CHECK(changed.test.tolerance.maxDiffRatio == 0.25);
  CHECK(changed.test.toleranceOrigin.at("maxDiffRatio") == "-D");

  files.write("flag.test.json", R"({"checks": []})");
  CHECK(files.load().checks.empty());
  CHECK(files.load().test.frames == std::vector<int>{5});
}

TEST_CASE("errors in the sidecar name it, with line and column") {
  const Files files;
  files.write("flag.json", sceneWith(R"("titel": "t")"));
  files.write("flag.test.json", "{\"test\": {\"frames\": [0, 500]},\n \"seed\": 3}");
  const std::string report = files.errors();
  INFO(report);
  CHECK(has(report, "/flag.json:2:1: error: unknown key \"titel\"; did you mean \"title\"?"));
  CHECK(has(report, "/flag.test.json:1:21: error: frame 500 is beyond the scene's last frame, 119"));
  CHECK(has(report, "/flag.test.json:2:2: error: unknown key \"seed\"; known here: test, checks"));
  files.write("flag.test.json", "{\"test\": ");
  CHECK(has(files.errors(), "/flag.test.json:1:"));
  files.write("flag.test.json", "[1]");
  CHECK(has(files.errors(), "/flag.test.json:1:1: error: expected an object, found a list"));
  files.write("flag.test.json", "");
  CHECK(has(files.errors(), "/flag.test.json:1:1: error: the text is empty"));
}

TEST_CASE("a test requires its frames even if an override shortens the scene") {
  const Files files;
  files.write("flag.json", sceneWith(R"("test": {"frames": [0, 119]})"));
  CHECK(files.errors().empty());
  CHECK(has(files.errors({"time.duration=1"}), "frame 119 is beyond the scene's last frame, 59"));
}
