#include "unit/scene/toy.hpp"

#include <cmath>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;

TEST_CASE("a scene with every section is read") {
  const Scene scene = parse(R"({"$schema": "x", "version": 1, "title": "t", "seed": 9, "numerics": "fast",
    "render": {"size": [64, 32], "samples": 1, "exposure": 0.5, "vignette": 0.25},
    "time": {"fps": 24, "start": 1, "duration": 1.5},
    "camera": {"position": [1, 2, 3], "target": [0, 1, 0], "fieldOfView": 30, "roll": 5, "near": 0.1, "far": 50},
    "sun": {"direction": [0, 1, 0], "color": [1, 1, 1], "intensity": 2, "shadow": false, "shadowSize": 512,
            "shadowSoftness": 2},
    "sky": {"zenith": [0, 0, 1], "horizon": [1, 1, 1], "ground": [0, 0, 0], "ambient": 0.5},
    "ground": {"height": -1},
    "objects": {"zebra": {"cloth": {"torn": true, "threads": 4, "stretch": 0.5, "slack": 2, "wind": [1, 2, 3],
      "grid": [3, 5], "holes": [[1, 2], [3, 4]], "note": "n", "passes": 7, "cuts": [], "shape": "round",
      "sides": ["right", "left"], "worn": {"amount": 1}, "seam": {"width": 2}, "pins": [{"row": 3}, {"weight": 4}]},
      "material": {"roughness": 0.1}}, "ape": {"capsule": {}}}})");
  CHECK(scene.numerics == Numerics::fast);
  CHECK(scene.seed == 9);
  CHECK(scene.render.size == glm::ivec2(64, 32));
  CHECK(scene.frameCount() == 36);
  CHECK(scene.camera.position.at(0) == glm::vec3(1, 2, 3));
  CHECK(scene.sun.shadowSize == 512);
  CHECK(scene.ground);
  CHECK(scene.ground->height == -1.0F);
  REQUIRE(scene.objects.size() == 2);
  CHECK(scene.objects[0].name == "zebra");  // Objects keep the order of the file.
  CHECK(scene.objects[0].kind == "cloth");
  CHECK(scene.objects[0].material.roughness == 0.1F);
  CHECK(scene.objects[1].kind == "capsule");
  const Cloth& cloth = clothOf(scene);
  CHECK(cloth.torn);
  CHECK(cloth.slack == 2.0);
  CHECK(cloth.holes == std::vector<glm::ivec2>{{1, 2}, {3, 4}});
  CHECK(cloth.passes == 7);
  CHECK(cloth.cuts.empty());
  CHECK(cloth.shape == Shape::round);
  CHECK(cloth.sides == std::vector<int>{1, 0});
  CHECK(cloth.hasWear);
  CHECK(cloth.seam == 2.0F);
  REQUIRE(cloth.pins.size() == 2);
  CHECK(cloth.pins[0].row == 3);
  CHECK(cloth.pins[1].weight == 4.0F);
}

TEST_CASE("a minimal scene has the defaults") {
  const Scene scene = parse(R"({"version": 1})");
  CHECK(!scene.ground);
  CHECK(scene.objects.empty());
  CHECK(scene.render.size == glm::ivec2(1280, 720));
  CHECK(scene.frameCount() == 120);
  CHECK(scene.hash.size() == 32);
  CHECK(parse(R"({"version": 1, "time": {"duration": 0}})").frameCount() == 1);
}

TEST_CASE("the scene hash covers text and overrides") {
  const std::string hash = parse(R"({"version": 1})").hash;
  CHECK(parse(R"({"version": 1})").hash == hash);
  CHECK(parse(R"({"version":  1})").hash != hash);
  CHECK(parse(R"({"version": 1})", {"seed=1"}).hash != hash);
}

TEST_CASE("all errors of a scene are reported at once, ordered by position") {
  const std::string report = mistakes(R"({
  "time": {"fps": "fast", "duration": -1},
  "render": {"size": [0, 20], "samples": 2.5},
  "objects": {"flag": {"cloth": {"wnd": [1, 2, 3], "threads": 11}}, "b": {"clothh": {}}}
})");
  const std::vector<std::string> expected = {
      "s.json:1:1: error: the scene has no version; add \"version\": 2\n",
      "s.json:2:19: error: expected a number, found a string\n",
      "s.json:2:39: error: \"duration\" must be at least 0 s, found -1\n",
      "s.json:3:23: error: \"size\" must be between 1 and 16384 pixels, found 0\n",
      "s.json:3:42: error: expected a whole number, found 2.5\n",
      "s.json:4:34: error: unknown key \"wnd\"; did you mean \"wind\"?\n",
      "s.json:4:63: error: \"threads\" must be between 1 and 10, found 11\n",
      "s.json:4:75: error: unknown kind of object \"clothh\"; did you mean \"cloth\"?\n"};
  std::size_t at = 0;
  for (const std::string& line : expected) {
    INFO(line, "in\n", report);
    const std::size_t found = report.find(line, at);
    REQUIRE(found != std::string::npos);
    at = found;
  }
}

TEST_CASE(
    "an unknown key of an object is explained if it belongs to a material or names a kind otherwise") {
  const auto report = [](const char* key) {
    return mistakes(
        fmt::format(R"({{"version": 1, "objects": {{"a": {{"cloth": {{}}, "{}": 1}}}}}})", key));
  };
  CHECK(report("color").find("it is part of a material: \"material\": {\"color\": ...}") !=
        std::string::npos);
  CHECK(report("cube").find("did you mean \"box\"?") != std::string::npos);
  CHECK(report("sheet").find("did you mean \"cloth\"?") != std::string::npos);
}

TEST_CASE("a wrong type error names the expected type") {
  const auto says = [](const char* member, const char* message) {
    const std::string report = mistakes(withCloth(member));
    INFO(report);
    return has(report, message);
  };
  CHECK(says(R"("torn": 1)", "s.json:3:10: error: expected true or false, found a number"));
  CHECK(says(R"("threads": null)", "expected a whole number, found null"));
  CHECK(says(R"("threads": 1e300)", "\"threads\" must be between 1 and 10, found 1e+300"));
  CHECK(says(R"("stretch": true)", "expected a number, found a boolean"));
  CHECK(says(R"("stretch": 2)", "\"stretch\" must be between 0 and 1 m/N, found 2"));
  CHECK(says(R"("slack": -1)", "\"slack\" must be at least 0 m, found -1"));
  CHECK(says(R"("slack": 1e10)", "\"slack\" must be between 0 and 1e+09 m"));
  CHECK(says(R"("seam": {"width": 0})", "\"width\" must be greater than 0 m, found 0"));
  CHECK(says(R"("seam": {"width": 1e-30})", "\"width\" must be between 1e-09 and 1e+09 m, found 1e-30"));
  CHECK(says(R"("seam": 3)", "expected an object, found a number"));
  CHECK(says(R"("wind": 3)", "expected a list of three numbers, found a number"));
  CHECK(says(R"("wind": [1, 2])", "expected a list of three numbers, found 2 items"));
  CHECK(says(R"("wind": [1, "x", 2])", "s.json:3:14: error: expected a number, found a string"));
  CHECK(says(R"("grid": [2.5, 4])", "expected a whole number, found 2.5"));
  CHECK(says(R"("grid": [1])", "expected a list of two whole numbers, found 1 items"));
  CHECK(says(R"("holes": {})", "expected a list of pairs [[a, b], ...], found an object"));
  CHECK(says(R"("note": [])", "expected a string, found a list"));
  CHECK(says(R"("passes": "many")", "expected a whole number or \"auto\", found \"many\""));
  CHECK(says(R"("passes": 0)", "\"passes\" must be between 1 and 99, found 0"));
  CHECK(says(R"("cuts": [1, 12])", "\"cuts\" must be between 0 and 9, found 12"));
  CHECK(says(R"("shape": "falt")", "unknown shape \"falt\"; did you mean \"flat\"?"));
  CHECK(says(R"("shape": "cube")", "unknown shape \"cube\"; known here: round, flat"));
  CHECK(says(R"("sides": ["left", "left"])", "\"left\" is listed twice"));
  CHECK(says(R"("pins": [{}, {}, {}, {}, {}])", "\"pins\" may have 4 items, found 5"));
  CHECK(says(R"("pins": [{"rwo": 1}])", "unknown key \"rwo\"; did you mean \"row\"?"));
  CHECK(says(R"("threads": 7)", "s.json:3:13: error: seven threads tangle"));
  CHECK(mistakes(withCloth(R"("passes": "auto")")).empty());
  CHECK(mistakes(withCloth(R"("threads": 3.0)")).empty());
}

TEST_CASE("an unknown key without a similar name lists the known keys") {
  CHECK(has(mistakes(withCloth(R"("seam": {"zzzzzz": 1})")), "unknown key \"zzzzzz\"; known here: width"));
  CHECK(has(mistakes("{\"version\": 1, \"tiem\": {}}"), "did you mean \"time\"?"));
}

TEST_CASE("unsupported scene versions are refused") {
  CHECK(has(mistakes("{\"version\": 3, \"new\": 1}"),
            "s.json:1:13: error: unknown version 3; this program reads versions 1 to 2"));
  CHECK(!has(mistakes("{\"version\": 3, \"new\": 1}"), "unknown key"));
  CHECK(has(mistakes("{\"version\": \"1\"}"), "expected a whole number, found a string"));
}

TEST_CASE("an object without exactly one kind, or with an invalid name, is refused") {
  const auto withObjects = [](const std::string& objects) {
    return mistakes("{\"version\": 1,\n\"objects\": " + objects + "}");
  };
  CHECK(has(withObjects(R"({"a": {}})"),
            "s.json:2:13: error: object \"a\" has no kind; give it one of: cloth, capsule"));
  CHECK(has(withObjects(R"({"a": {"cloth": {}, "capsule": {}}})"), "object \"a\" is a \"cloth\" already"));
  CHECK(has(withObjects(R"({"a b": {"cloth": {}}})"), "object name \"a b\" must be"));
  CHECK(has(withObjects(R"({"a": 3})"), "expected an object, such as {\"sphere\": {}}, found a number"));
  CHECK(has(withObjects("[]"), "expected objects by name"));
  std::string many = "{\"a0\": {\"capsule\": {}}";
  for (int i = 1; i <= 1000; ++i) many += ", \"a" + std::to_string(i) + "\": {\"capsule\": {}}";
  CHECK(has(withObjects(many + "}"), "more than 1000 objects"));
}

TEST_CASE("errors that involve several values are reported") {
  const auto says = [](const std::string& member, const char* message) {
    const std::string report = mistakes("{\"version\": 1, " + member + "}");
    INFO(report);
    return has(report, message);
  };
  CHECK(says(R"("camera": {"near": 5, "far": 2})",
             "s.json:1:35: error: \"near\" (5 m) must be less than \"far\" (2 m)"));
  CHECK(says(R"("camera": {"position": [0, 0, 0]})", "are the same point"));
  CHECK(!says(R"("camera": {"near": "x", "far": 0.01})", "must be less than"));
  CHECK(says(R"("time": {"duration": 1e6})", "the limit is 10 million"));
  CHECK(says(R"("time": {"fps": 0})", "\"fps\" must be between 0.001 and 100000 frames/s, found 0"));
  CHECK(says(R"("sun": {"direction": [0, 0, 0]})", "points nowhere"));
  CHECK(says(R"("sun": {"color": [1, -0.1, 1]})", "\"color\" must be at least 0, found -0.1"));
  CHECK(
      says(R"("ground": {"fadeStart": 50})", "\"fadeStart\" (50 m) must be less than \"fadeEnd\" (40 m)"));
  CHECK(says(R"("render": {"samples": 17})", "\"samples\" must be between 1 and 16, found 17"));
  CHECK(says(R"("render": {"size": [16385, 1]})",
             "\"size\" must be between 1 and 16384 pixels, found 16385"));
}

TEST_CASE("keyframes: values at, between and outside the keys are right") {
  const Scene scene = parse(withCloth(
      R"("gust": {"keys": [[1, 2], [3, 4]]}, "lift": {"keys": [[0, [0, 0, 0]], [1, [4, 0, 0]]], "ease": "smooth"})"));
  const Cloth& cloth = clothOf(scene);
  CHECK(cloth.gust.moves());
  CHECK(cloth.gust.at(-5) == 2.0F);
  CHECK(cloth.gust.at(1) == 2.0F);
  CHECK(cloth.gust.at(2) == 3.0F);
  CHECK(cloth.gust.at(3) == 4.0F);
  CHECK(cloth.gust.at(99) == 4.0F);
  CHECK(cloth.lift.ease() == Ease::smooth);
  CHECK(cloth.lift.at(0.5) == glm::vec3(2, 0, 0));
  CHECK(cloth.lift.at(0.25) == glm::vec3(0.625F, 0, 0));
  CHECK(!clothOf(parse(withCloth(R"("gust": {"keys": [[1, 2]]})"))).gust.moves());
}

TEST_CASE("errors in keyframes are reported") {
  const auto says = [](const std::string& gust, const char* message) {
    const std::string report = mistakes(withCloth("\"gust\": " + gust));
    INFO(report);
    return has(report, message);
  };
  CHECK(says(R"({"keys": [[1, 1], [0, 2]]})",
             "s.json:3:29: error: keyframe times must increase; 0 s follows 1 s"));
  CHECK(says(R"({"keys": [[0, 1], [0, 2], [0, 3]]})",
             "s.json:3:37: error: two keyframes at one time are a jump; this is the third at 0 s"));
  CHECK(says(R"({"keys": [[0, 9]]})", "s.json:3:24: error: \"gust\" must be between 0 and 5 m/s, found 9"));
  CHECK(says(R"({"keys": [[0, [1]]]})", "expected a number, found a list"));
  CHECK(says(R"({"keys": [3]})", "expected a keyframe [time, value]"));
  CHECK(says(R"({"keys": []})", "expected at least one keyframe"));
  CHECK(says(R"({"keys": 1})", "expected at least one keyframe"));
  CHECK(says(R"({})", "keyframes need \"keys\""));
  CHECK(says(R"({"keys": [[0, 1]], "ease": "smoth"})", "unknown ease \"smoth\"; did you mean \"smooth\"?"));
  CHECK(says(R"({"keys": [[0, 1]], "eas": "linear"})", "unknown key \"eas\"; did you mean \"ease\"?"));
}
