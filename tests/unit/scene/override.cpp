#include "scene/json/scene_error.hpp"
#include "unit/scene/toy.hpp"

#include <doctest/doctest.h>

using namespace simreel::scene;
using namespace simreel::scene::toy;

TEST_CASE("an override changes and adds members, and reaches into lists") {
  const std::string text = withCloth(R"("wind": [1, 2, 3], "pins": [{"row": 1}, {"row": 2}])");
  const Scene scene =
      parse(text, {"objects.flag.cloth.wind=[3,0,1]", "objects.flag.cloth.pins.1.row=7", "time.fps=30",
                   "title=two words", "objects.flag.material.roughness=0.5",
                   "objects.pole={\"capsule\": {\"radius\": 2}}", "objects.flag.cloth.wind.1=9"});
  CHECK(clothOf(scene).wind == glm::vec3(3, 9, 1));
  CHECK(clothOf(scene).pins.at(1).row == 7);
  CHECK(scene.time.fps == 30.0);
  CHECK(scene.title == "two words");
  CHECK(scene.objects.at(0).material.roughness == 0.5F);
  CHECK(scene.objects.at(1).name == "pole");
  CHECK(parse(text, {"title=\"quoted\""}).title == "quoted");
  CHECK(parse(text, {"title="}).title.empty());
  CHECK(parse(text, {"title=a=b"}).title == "a=b");
  CHECK(parse(text, {"ground={}"}).ground);
  CHECK(parse(text, {"seed=2", "seed=3"}).seed == 3);
}

TEST_CASE("an override can correct an error of the file") {
  CHECK(mistakes("{\"version\": 1, \"seed\": \"x\"}", {"seed=4"}).empty());
}

TEST_CASE("errors in overrides point to their -D option") {
  const std::string text = withCloth(R"("pins": [{"row": 1}])");
  CHECK(mistakes(text, {"objects.flag.cloth.wnd=[3,0,1]"}) ==
        "-D objects.flag.cloth.wnd=[3,0,1]: error: unknown key \"wnd\"; did you mean \"wind\"?\n"
        "  objects.flag.cloth.wnd=[3,0,1]\n"
        "                     ^~~");
  CHECK(mistakes(text, {"time.fps=fast"}) ==
        "-D time.fps=fast: error: expected a number, found a string\n"
        "  time.fps=fast\n"
        "           ^~~~");
  CHECK(has(mistakes(text, {"tiem.fps=3"}),
            "-D tiem.fps=3: error: unknown key \"tiem\"; did you mean \"time\"?"));
  CHECK(has(mistakes(text, {"time.fps=-3"}), "-D time.fps=-3: error: \"fps\" must be between 0.001 and"));
  CHECK(has(mistakes(text, {"camera.position=[1,2"}), "-D camera.position=[1,2: error: the text ends"));
  CHECK(has(mistakes(text, {"objects.flag.cloth.pins.1.row=1"}),
            "no item 1; the list has 1, counted from 0"));
  CHECK(has(mistakes(text, {"objects.flag.cloth.pins.x.row=1"}), "\"x\" is not an index"));
  CHECK(has(mistakes(text, {"objects.flag.cloth.pins.-1.row=1"}), "\"-1\" is not an index"));
  CHECK(has(mistakes(text, {"version.x=1"}), "\"version\" is a number, which holds nothing named \"x\""));
  CHECK(has(mistakes(text, {"a..b=1"}), "a name is missing in this path"));
  CHECK(has(mistakes(text, {"a.=1"}), "a name is missing in this path"));
  CHECK(has(mistakes(text, {"title=\xFF"}), "not valid UTF-8"));
  CHECK(has(mistakes("[]", {"a=1"}), "is not an index"));
  std::string deep = "a";
  for (int i = 0; i < 5000; ++i) deep += ".a";
  CHECK(has(mistakes(text, {deep + "=1"}), "this path is too deep"));
}

TEST_CASE("an override does not create objects or list items implicitly") {
  const std::string text = withCloth(R"("wind": [1, 2, 3])");
  CHECK(mistakes(text, {"objects.flga.cloth.wind=[3,0,1]"}) ==
        "-D objects.flga.cloth.wind=[3,0,1]: error: no object is named \"flga\"; did you mean \"flag\"? "
        "(-D objects.flga={...} adds one)\n"
        "  objects.flga.cloth.wind=[3,0,1]\n"
        "          ^~~~");
  CHECK(has(mistakes(text, {"objects.pole.capsule={}"}), "no object is named \"pole\"; known here: flag"));
  CHECK(has(mistakes("{\"version\": 1}", {"objects.a.cloth.wind=[1,2,3]"}),
            "no object is named \"a\"; the scene has none"));
  CHECK(
      has(mistakes(text, {"objects.flag.cloth.pins.0.row=1"}),
          "\"pins\" is not given, so it has no item 0; give all of it: -D objects.flag.cloth.pins=[...]"));
  CHECK(parse("{\"version\": 1}", {"objects.a={\"cloth\": {}}"}).objects.at(0).name == "a");
  CHECK(parse(text, {"objects.b={\"cloth\": {}}", "objects.b.cloth.wind=[7,8,9]"}).objects.size() == 2);
  CHECK(parse(text, {"ground.height=-2"}).ground->height == -2.0F);
}

TEST_CASE("a scene stores its overrides in a form that can be typed again") {
  const Scene scene = parse(withCloth(""), {"seed=3", "title=two words"});
  CHECK(scene.overrides == std::vector<std::string>{"seed=3", "title=two words"});
  CHECK(asArguments(scene.overrides) == "-D seed=3 -D 'title=two words'");
  CHECK(asArguments(parse(withCloth("")).overrides).empty());
}

TEST_CASE("an override needs a path and a value") {
  CHECK_THROWS_AS(static_cast<void>(parseOverride("time.fps")), simreel::UserError);
  CHECK_THROWS_AS(static_cast<void>(parseOverride("=3")), simreel::UserError);
  CHECK(parseOverride("a.b=c=d").path == "a.b");
  CHECK(parseOverride("a.b=c=d").value == "c=d");
}

TEST_CASE("each mistake of a scene has its place and its path") {
  const std::string text = "{\"version\": 1,\n \"objects\": {\"flag\": {\"cloth\": {\"grid\": [8, 1]}}}}";
  std::vector<Problem> problems;
  try {
    static_cast<void>(parse(text, {"objects.flag.cloth.threads=11", "titel=x"}, "a.json"));
  } catch (const SceneError& error) {
    problems = error.problems();
  }
  REQUIRE(problems.size() == 3);
  CHECK(problems[0].file == "a.json");
  CHECK(problems[0].line == 2);
  CHECK(problems[0].column == 45);
  CHECK(problems[0].path == "objects.flag.cloth.grid.1");
  CHECK(problems[1].path == "objects.flag.cloth.threads");
  CHECK(problems[1].line == 0);
  CHECK(problems[2].path == "titel");
}

TEST_CASE("errors of file and overrides are reported together, the file's first") {
  const std::string report = mistakes("{\"version\": 1, \"sed\": 1}", {"time.fps=0"});
  CHECK(report.find("s.json:1:16") < report.find("-D time.fps=0"));
  CHECK(has(report, "-D time.fps=0"));
}
