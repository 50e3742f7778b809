// Tests keys that have no effect because of another key. Each of them must cause a message at its position.
// Keys with an effect must cause no message.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;  // NOLINT

namespace {

std::vector<std::string> remarksOn(const std::string& members,
                                   const std::vector<scene::Override>& overrides = {}) {
  return scene::parseScene(R"({"version": 1, )" + members + "}", "s.json", overrides, sim::kinds()).remarks;
}

struct Pair {
  const char *ruled, *works;  ///< member of the scene that makes `key` ineffective, and one that does not
  const char* key;            ///< text of the key with its value
};

/// Expects one message at the position of the key if the key has no effect, and otherwise no message.
void check(const std::string& before, const std::vector<Pair>& pairs, const std::string& after) {
  for (const Pair& pair : pairs) {
    CAPTURE(pair.key);
    CAPTURE(pair.ruled);
    const std::string key(pair.key);
    const std::string name = key.substr(0, key.find(':'));
    const auto with = [&](const char* ruler) {
      return before + ruler + (*ruler != 0 ? ", " : "") + key + after;
    };
    const std::vector<std::string> said = remarksOn(with(pair.ruled));
    REQUIRE(said.size() == 1);
    const std::size_t column = std::string(R"({"version": 1, )").size() + with(pair.ruled).rfind(key) + 1;
    CHECK(said[0].starts_with(fmt::format("s.json:1:{}: warning: {} is for ", column, name)));
    CHECK(said[0].find("; here it does nothing\n") != std::string::npos);
    CHECK(said[0].back() == '~');
    CHECK(remarksOn(with(pair.works)) == std::vector<std::string>());
  }
}

}  // namespace

TEST_CASE("idle: picture, light and camera parameters without effect are reported") {
  check(R"("render": {)",
        {{"", R"("quality": "high")", R"("raySamples": 8)"},
         {R"("quality": "standard")", R"("quality": "high")", R"("raySamples": 8)"},
         {"", R"("quality": "standard")", R"("occlusionRadius": 1)"},
         {R"("quality": "high")", R"("quality": "standard")", R"("occlusionRadius": 1)"}},
        "}");
  check(R"("render": {"bloom": {)",
        {{"", R"("strength": 1)", R"("threshold": 2)"},
         {R"("strength": 0)", R"("strength": {"keys": [[0, 0], [1, 1]]})", R"("radius": 0.2)"}},
        "}}");
  check(R"("sun": {)",
        {{R"("shadow": false)", "", R"("shadowSize": 64)"},
         {R"("shadow": false)", "", R"("shadowSoftness": 2)"},
         {R"("shadow": false)", "", R"("diameter": 2)"}},
        "}");
  check(R"("ground": {)",
        {{R"("visible": false)", "", R"("color": [1, 0, 0])"},
         {R"("visible": false)", R"("visible": true)", R"("fadeEnd": 90)"}},
        "}");
  const char* const moves = R"("target": {"keys": [[0, [0, 0, 0]], [1, [1, 0, 0]]]})";
  check(R"("camera": {)", {{"", moves, R"("damping": 1)"}}, "}");
  check(R"("lights": {"a": {)",
        {{R"("shadow": false)", "", R"("shadowSize": 64)"},
         {R"("type": "area", "shadow": false)", R"("type": "area")", R"("radius": 0.1)"},
         {R"("type": "area", "shadow": false)", R"("shadow": false)", R"("radius": 0.1)"}},
        "}}");
  check(R"("lights": {"a": {"flicker": {)",
        {{R"("amount": 0)", R"("amount": 0, "sway": 0.1)", R"("rate": 9)"}}, "}}}");
}

TEST_CASE("idle: shadow map parameters are reported as without effect in ray tracing") {
  const char* const sun = R"("sun": {"shadowSize": 64}, "lights": {"a": {"shadowSoftness": 2}, "b": {}})";
  const std::string high = R"("render": {"quality": "high"}, )";
  CHECK(remarksOn(sun).empty());
  CHECK(remarksOn(high + sun).size() == 2);
  CHECK(remarksOn(R"("render": {"quality": "high", "rasterizer": "driver"}, )" + std::string(sun)).empty());
}

TEST_CASE("idle: material parameters without effect are reported") {
  const char* const field =
      R"("objects": {"f": {"life": {"display": {"layer": "none"}}}, "s": {"sphere": {}, "material": {)";
  const char* const skin = R"("skin": {"field": "f"})";
  check(field,
        {{skin, "", R"("color": [1, 0, 0])"},
         {skin, "", R"("roughness": 0.2)"},
         {"", R"("texture": "textures/boat.png")", R"("textureScale": [2, 2, 1])"},
         {"", R"("normalMap": "textures/boat.png")", R"("textureScale": [2, 2, 1])"},
         {"", R"("texture": "textures/boat.png")", R"("bump": 0.1)"},
         {"", R"("emission": [1, 1, 1])", R"("emissionStrength": 2)"}},
        "}}}");
  check(std::string(field) + R"("skin": {"field": "f", )",
        {{R"("look": "map")", R"("look": "leather")", R"("low": [0, 0, 0])"},
         {R"("look": "map")", R"("look": "leather")", R"("threshold": 0.2)"}},
        "}}}}");
  const std::string material = R"(, "material": {"color": [1, 0, 0]}}})";
  CHECK(remarksOn(R"("objects": {"o": {"sphere": {})" + material).empty());
  for (const char* kind : {R"("life": {})", R"("lenia": {})", R"("fluid": {})", R"("grayScott": {})",
                           R"("text": {"text": "a", "screen": {}})", R"("reaction": {"preset": "barkley"})",
                           R"("epidemic": {"infected": 0.1})"}) {
    CAPTURE(kind);
    const auto said = remarksOn(R"("objects": {"o": {)" + std::string(kind) + material);
    REQUIRE(said.size() == 1);
    CHECK(said[0].find("; here a material does nothing\n") != std::string::npos);
  }
}

TEST_CASE("idle: object parameters without effect are reported") {
  const auto object = [](const char* kind, const std::vector<Pair>& pairs, const char* before = "",
                         const char* after = "") {
    check(fmt::format(R"("objects": {{"o": {{"{}": {{{})", kind, before), pairs,
          std::string(after) + "}}}");
  };
  object("sphere",
         {{R"("collides": false)", "", R"("grip": 1)"}, {R"("collides": false)", "", R"("friction": 1)"}});
  object("plane", {{R"("visible": false)", "", R"("size": [1, 0, 1])"}});
  object("mesh", {{R"("shape": "sphere")", "", R"("size": [1, 0, 1])"},
                  {"", R"("shape": "sphere")", R"("radius": 1)"},
                  {R"("shape": "sphere")", R"("shape": "torus")", R"("tube": 0.1)"},
                  {R"("shape": "grass")", R"("shape": "plane")", R"("resolution": [9, 9])"},
                  {R"("file": "meshes/heart.ply")", R"("shape": "plane")", R"("resolution": [9, 9])"},
                  {"", R"("shape": "grass")", R"("blades": 9)"},
                  {"", R"("deform": [{"ripple": {}}])", R"("technique": "jobs")"},
                  {R"("deform": [{"ripple": {}}], "technique": "jobs")", R"("deform": [{"ripple": {}}])",
                   R"("readback": true)"}});
  object("cloth", {{R"("solver": "constraints")", "", R"("stiffness": 100)"},
                   {"", R"("solver": "constraints")", R"("compliance": 1e-4)"}});
  object("cloth", {{R"("gusts": 0)", "", R"("gustSize": 1)"}}, R"("air": {)", "}");
  object("cloth",
         {{R"("corners": ["top-left"])", R"("rows": [0])", R"("every": 2)"},
          {R"("rows": [0])", R"("rows": [0], "rotate": [0, 9, 0])", R"("pivot": [1, 0, 0])"}},
         R"("pins": [{)", "}]");
  object("cloth",
         {{R"("shape": "sphere")", R"("shape": "plane")", R"("size": [1, 0, 1])"},
          {"", R"("shape": "cylinder")", R"("length": 1)"}},
         R"("mesh": {)", "}");
  object("particles", {{R"("groups": [{}])", R"("groups": [{}], "method": "tree")", R"("opening": 0.4)"},
                       {R"("emitters": [{}])", R"("emitters": [{}], "attractor": {})", R"("gravity": 9.8)"},
                       {R"("emitters": [{}])", R"("groups": [{}])", R"("softening": 0.1)"}});
  object("particles",
         {{"", R"("shape": "disk")", R"("thickness": 0.1)"},
          {R"("shape": "disk")", R"("shape": "cube")", R"("spin": 1)"}},
         R"("groups": [{)", "}]");
  object("particles",
         {{"", R"("colorBy": "speed")", R"("colorTo": 4)"},
          {"", R"("additive": true)", R"("brightness": 4)"},
          {"", R"("additive": true)", R"("fade": 0.1)"}},
         R"("emitters": [{}], "look": {)", "}");
  object("particles", {{"", R"("strength": 1)", R"("size": 2)"}}, R"("emitters": [{}], "turbulence": {)",
         "}");
  object("fluid", {{R"("substeps": 4)", "", R"("courant": 2)"},
                   {R"("show": "speed")", "", R"("brightness": 2)"},
                   {"", R"("obstacles": [{}])", R"("obstaclesSlip": true)"},
                   {"", R"("strokes": [{"temperature": 1}])", R"("cooling": 1)"}});
  object("fluid",
         {{R"("shape": "box")", "", R"("radius": 4)"}, {"", R"("shape": "box")", R"("extent": [4, 4, 0])"}},
         R"("obstacles": [{)", "}]");
  object("lenia", {{"", R"("model": "smoothLife")", R"("bornMin": 0.2)"},
                   {R"("model": "smoothLife")", "", R"("kernels": [{}])"}});
  object("grayScott", {{"", R"("feedImage": "textures/boat.png")", R"("feedWhite": 0.04)"},
                       {R"("feed": 0.03, "kill": 0.06)", R"("feed": 0.03)", R"("preset": "maze")"}});
  object("cave",
         {{"", R"("ceiling": true)", R"("roof": 2)"}, {R"("connect": false)", "", R"("corridor": 3)"}});
  object("cave", {{"", R"("layer": "over")", R"("zoom": 2)"}}, R"("display": {)", "}");
  object("life", {{R"("tiled": true)", "", R"("border": [1, 1, 1])"}}, R"("display": {)", "}");
  object("wildfire", {{"", R"("strength": 1)", R"("direction": 90)"}},
         R"("strokes": [{"at": 0, "from": [9, 9, 0], "radius": 4, "value": 1}], "wind": {)", "}");
}

TEST_CASE("idle: parameters that only the command line makes ineffective are not reported") {
  const char* const scene =
      R"("render": {"quality": "high", "raySamples": 8, "bloom": {"strength": 1, "radius": 0.2}})";
  CHECK(remarksOn(scene).empty());
  CHECK(remarksOn(scene, {{"render.quality", "draft"}, {"render.bloom.strength", "0"}}).empty());
  const auto said = remarksOn(R"("render": {"quality": "draft"})", {{"render.raySamples", "8"}});
  REQUIRE(said.size() == 1);
  CHECK(said[0].starts_with("-D render.raySamples=8: warning: "));
  CHECK(remarksOn(R"("render": {"quality": "high"}, "sun": {"shadowSize": 64})").size() == 1);
  CHECK(remarksOn(R"("sun": {"shadowSize": 64})", {{"render.quality", "high"}}).empty());
}

TEST_CASE("idle: no shipped scene has parameters without effect") {
  for (const char* folder : {"assets/scenes", "tests/cli/scenes/stage"})
    for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() + "/" + folder))
      if (entry.path().extension() == ".json" &&
          entry.path().string().find(".test.json") == std::string::npos) {
        CAPTURE(entry.path());
        CHECK(scene::loadTestScene(entry.path(), {}, sim::kinds()).remarks == std::vector<std::string>());
      }
}

TEST_CASE("idle: values that are probably not intended are reported") {
  const auto said = [](const char* members) {
    const auto remarks = remarksOn(members);
    REQUIRE(remarks.size() == 1);
    return remarks[0];
  };
  const auto starts = [&](const char* members, const char* text) {
    CAPTURE(members);
    CHECK(said(members).find(text) != std::string::npos);
  };
  starts(R"("objects": {"o": {"sphere": {}, "material": {"color": [200, 30, 30]}}})", "above 1");
  starts(R"("objects": {"o": {"sphere": {}, "material": {"alpha": "blend"}}})",
         "\"alpha\" is for a material");
  starts(R"("sun": {"direction": [0, -1, 0]}, "ground": {})", "below the ground");
  starts(R"("camera": {"position": [0, 500, 1000]})", "nothing is drawn beyond \"far\", 200 m");
  starts(R"("camera": {"position": [0, 1, 5], "near": 10})", "nothing is drawn nearer than \"near\", 10 m");
  for (const char* good :
       {R"("objects": {"o": {"sphere": {}, "material": {"alpha": "blend", "opacity": 0.5}}})",
        R"("sun": {"direction": [0, -1, 0]})",
        R"("sun": {"direction": [0, -1, 0], "intensity": 0}, "ground": {})",
        R"("camera": {"position": [0, 500, 1000], "far": 2000})",
        R"("camera": {"position": [0, 500, 1000], "track": "o"}, "objects": {"o": {"sphere": {}}})"}) {
    CAPTURE(good);
    CHECK(remarksOn(good) == std::vector<std::string>());
  }
  CHECK_THROWS_WITH_AS(
      static_cast<void>(
          remarksOn(R"("objects": {"o": {"sphere": {"radius": {"keys": [[0, 1], [1, 2]]}}}})")),
      doctest::Contains("expected a number, found keyframes; \"radius\" cannot have keyframes"), UserError);
  CHECK_THROWS_WITH_AS(
      static_cast<void>(remarksOn(R"("camera": {"track": "l"}, "objects": {"l": {"life": {}}})")),
      doctest::Contains("object \"l\" is drawn over the picture and has no place in the world"), UserError);
}
