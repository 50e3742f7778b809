// Tests stages of scenes with version 2: lamps of dark stages, text on bright ones, cameras and grounds.
#include "scene/framing.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/body/parameters.hpp"
#include "sim/life/parameters.hpp"
#include "sim/particles/parameters.hpp"
#include "sim/text/parameters.hpp"
#include "sim/water/parameters.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::test::stage_second {

namespace {

scene::Scene parsed(const std::string& objects, const std::string& more = "", int version = 2) {
  return scene::parseScene(fmt::format(R"({{"version": {}, {}"objects": {}}})", version, more, objects),
                           sourceFolder() + "/assets/scenes/x.json", {}, sim::kinds());
}

const std::string ball = R"({"m": {"sphere": {}}})";
const std::string fields = R"({"l": {"life": {"size": [64, 64])";

const scene::Light* lampOf(const scene::Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.lights.begin(), scene.lights.end(),
                                  [&](const scene::Light& light) { return light.name == name; });
  return found == scene.lights.end() ? nullptr : &*found;
}

glm::vec3 inkOf(const scene::Scene& scene) {
  return dynamic_cast<const sim::TextParameters&>(*scene.objects.back().parameters).screen.color.at(0);
}

}  // namespace

TEST_CASE("stage: a dark stage of version 2 has a card and a low fill where metal is drawn") {
  const std::string night = R"("stage": "night", )";
  const auto metal = [](const char* members) {
    return fmt::format(R"({{"m": {{"sphere": {{}}, "material": {{{}}}}}}})", members);
  };
  const scene::Scene gold = parsed(metal(R"("metallic": 1)"), night);
  const scene::Light* const card = lampOf(gold, "card");
  REQUIRE(card != nullptr);
  CHECK(card->type == scene::Light::Type::area);
  CHECK_FALSE(card->shadow);
  // The lower edges of both lamps are below the horizon of the objects.
  for (const char* name : {"card", "fill"}) {
    const scene::Light& lamp = *lampOf(gold, name);
    CHECK(lamp.position.at(0).y - 0.5F * lamp.area.height.at(0) < lamp.area.target.at(0).y - 1);
  }
  const scene::Scene matt = parsed(metal(R"("metallic": 0.4)"), night);
  CHECK(lampOf(matt, "card") == nullptr);
  CHECK(lampOf(matt, "fill")->area.height.at(0) < lampOf(gold, "fill")->area.height.at(0));
  CHECK(lampOf(parsed(metal(R"("metallic": 1)"), R"("stage": "studio", )"), "card") == nullptr);
  CHECK(lampOf(parsed(metal(R"("metallic": 1)"), night, 1), "card") == nullptr);
}

TEST_CASE("stage: dark stages of version 2 have a fill and a softbox on the camera's side") {
  const auto has = [](const std::string& members, int version = 2) {
    const scene::Scene scene = parsed(ball, members, version);
    CHECK((lampOf(scene, "fill") == nullptr) == (lampOf(scene, "softbox") == nullptr));
    return lampOf(scene, "fill") != nullptr;
  };
  for (const char* dark :
       {R"("void")", R"("night")", R"("blueprint")", R"({"backdrop": [0.01, 0.01, 0.01]})"}) {
    CAPTURE(dark);
    const std::string stage = fmt::format(R"("stage": {}, )", dark);
    CHECK(has(stage));
    CHECK_FALSE(has(stage, 1));
    CHECK_FALSE(has(stage + R"("sun": {"direction": [1, 0, 0]}, )"));
    const scene::Scene scene = parsed(ball, stage);
    const glm::vec3 eye = scene.camera.position.at(0);
    for (const char* name : {"fill", "softbox"}) {
      const scene::Light& lamp = *lampOf(scene, name);
      CHECK(lamp.type == scene::Light::Type::area);
      const glm::vec3 at = lamp.position.at(0);
      CHECK(at.x * eye.x + at.z * eye.z > 0);
      CHECK(at.y > 0);
    }
    CHECK(lampOf(scene, "fill")->position.at(0).z > 1);  // The lamp lights surfaces that face +z.
  }
  CHECK_FALSE(has(""));
  CHECK_FALSE(has(R"("stage": "paper", )"));
  const scene::Scene own =
      parsed(ball, R"("stage": "void", "lights": {"fill": {"position": [0, 9, 0]}}, )");
  CHECK(lampOf(own, "fill")->position.at(0) == glm::vec3(0, 9, 0));
  CHECK(lampOf(own, "softbox") != nullptr);
}

TEST_CASE("stage: the rim of a glossy floor stands high") {
  const auto rise = [](const std::string& members) {
    return glm::normalize(lampOf(parsed(ball, members), "rim")->position.at(0)).y;
  };
  CHECK(rise("") < 0.7F);
  CHECK(rise(R"("ground": {"roughness": 0.8}, )") < 0.7F);
  CHECK(rise(R"("ground": {"roughness": 0.1}, )") > 0.9F);
}

TEST_CASE("stage: beside water, objects of version 2 have the colours of a palette") {
  const std::string harbour = R"({"sea": {"water": {"level": 0}}, "b": {"box": {}}})";
  const scene::Scene now = parsed(harbour);
  CHECK_FALSE(now.staged);
  CHECK(now.objects[1].material.color != parsed(harbour, "", 1).objects[1].material.color);
  CHECK(now.sky.ground.at(0) == now.sky.horizon.at(0));
  const scene::Scene given = parsed(harbour, R"("sky": {"ground": [1, 0, 0]}, )");
  CHECK(given.sky.ground.at(0) == glm::vec3(1, 0, 0));
}

TEST_CASE("time: in version 2 emitters run for a particle's life before frame 0, if nothing else moves") {
  const auto start = [](const std::string& more, int version = 2, const std::string& emitter = "{}") {
    return parsed(fmt::format(R"({{"s": {{"particles": {{"emitters": [{}]}}}}{}}})", emitter, more), "",
                  version)
        .time.start;
  };
  CHECK(start("") == doctest::Approx(2.6));
  CHECK(start("", 1) == 0);
  CHECK(start("", 2, R"({"lifetime": 60})") == 4);
  CHECK(start("", 2, R"({"from": 1})") == 0);
  CHECK(start(R"(, "p": {"plane": {}})") == doctest::Approx(2.6));
  CHECK(start(R"(, "c": {"cloth": {}})") == 0);
  CHECK(parsed(R"({"s": {"particles": {"emitters": [{}]}}})", R"("time": {"start": 0}, )").time.start == 0);
}

TEST_CASE("stage: writing on the screen is dark on bright stages of version 2") {
  const std::string own = R"({"m": {"sphere": {}}, "t": {"text": {"screen": {"color": [1, 0, 0]}}}})";
  const std::string panel = R"({"m": {"sphere": {}}, "t": {"text": {"screen": {"backdrop": 0.5}}}})";
  const std::string plain = R"({"m": {"sphere": {}}, "t": {"text": {"screen": {}}}})";
  CHECK(inkOf(parsed(plain)).x < 0.1F);
  CHECK(inkOf(parsed(plain, R"("stage": "paper", )")).x < 0.1F);
  CHECK(inkOf(parsed(plain, R"("stage": "void", )")) == glm::vec3(1));
  CHECK(inkOf(parsed(plain, R"("stage": {"backdrop": [0.02, 0.02, 0.02]}, )")) == glm::vec3(1));
  CHECK(inkOf(parsed(plain, R"("stage": false, )")) == glm::vec3(1));
  CHECK(inkOf(parsed(plain, "", 1)) == glm::vec3(1));
  CHECK(inkOf(parsed(own)) == glm::vec3(1, 0, 0));
  CHECK(inkOf(parsed(panel)) == glm::vec3(1));
}

TEST_CASE("stage: a tracking camera of version 2 stands where everything is in view") {
  const std::string track = R"("camera": {"track": "m"}, )";
  const std::string two = R"({"m": {"sphere": {"position": [3, 0, 0]}}, "n": {"sphere": {}}})";
  const scene::Scene tracking = parsed(two, track),
                     aimed = parsed(two, R"("camera": {"target": [3, 0, 0]}, )");
  CHECK(tracking.camera.position.at(0) == aimed.camera.position.at(0));
  CHECK(tracking.camera.fieldOfView.at(0) == aimed.camera.fieldOfView.at(0));
  CHECK(parsed(ball, track, 1).camera.position.at(0) == scene::Camera().position.at(0));
  const std::string turning = R"({"turn": {"keys": [[0, 0], [4, 360]]}})";
  const std::string orbit = R"("camera": {"orbit": )" + turning + "}, ",
                    both = R"("camera": {"track": "m", "orbit": )" + turning + "}, ";
  CHECK(parsed(ball, both).camera.orbit->distance.at(0) ==
        parsed(ball, orbit).camera.orbit->distance.at(0));
  const scene::Scene placed = parsed(ball, R"("camera": {"track": "m", "position": [1, 2, 3]}, )");
  CHECK(placed.camera.position.at(0) == glm::vec3(1, 2, 3));
}

TEST_CASE("stage: a ground without a height lies below particles that fall, and where others rise") {
  const auto height = [](const std::string& velocity, const std::string& more = "") {
    const scene::Scene scene = parsed(fmt::format(R"({{"p": {{"particles": {{"acceleration": [0, -9.81, 0],
                              "emitters": [{{"radius": 0, "position": [0, 3, 0], "velocity": {}}}]}}}}{}}})",
                                                  velocity, more),
                                      R"("ground": {}, )");
    return scene.ground->height;
  };
  CHECK(height("[0, 6, 0]") == 3);
  CHECK(height("[0, 0, 0]") < 0);
  CHECK(height("[0, -1, 0]") < 0);
  CHECK(height("[0, 0, 0]", R"(, "m": {"sphere": {}})") == -1);
}

TEST_CASE("stage: one warning says that the camera is below the ground of the scene") {
  const auto count = [](const std::string& members) { return parsed(ball, members).remarks.size(); };
  const std::string below = R"("camera": {"position": [0, -3, 6]}, )";
  const std::vector<std::string> said = parsed(ball, below + R"("ground": {}, )").remarks;
  REQUIRE(said.size() == 1);
  CHECK(said[0].find("the camera is below the ground") != std::string::npos);
  CHECK(said[0].find("\"visible\": false") != std::string::npos);
  CHECK(count(R"("camera": {"orbit": {"elevation": -20}}, "ground": {}, )") == 1);
  CHECK(count(below) == 0);
  CHECK(count(below + R"("ground": {"visible": false}, )") == 0);
  CHECK(count(R"("ground": {}, )") == 0);
  CHECK(count(R"("camera": {"position": [0, -3, 6], "target": [0, -9, 0]}, "ground": {}, )") == 0);
}

TEST_CASE("stage: one warning says that a field over the whole picture hides what is in the world") {
  const auto said = [](const std::string& display, const std::string& text) {
    return parsed(fields + fmt::format(R"(, "display": {}}}}}, "t": {{"text": {}}}}})", display, text))
        .remarks;
  };
  const std::vector<std::string> hidden = said("{}", "{}");
  REQUIRE(hidden.size() == 1);
  CHECK(hidden[0].find("\"t\" is in the world and hidden behind the picture of \"l\"") !=
        std::string::npos);
  CHECK(hidden[0].find("\"screen\": {}") != std::string::npos);
  CHECK(said("{}", R"({"screen": {}})").empty());
  CHECK(said(R"({"layer": "behind"})", "{}").empty());
  CHECK(said(R"({"extent": [0.5, 1, 0]})", "{}").empty());
  CHECK(said(R"({"opacity": 0.5})", "{}").empty());
}

TEST_CASE("stage: a field behind all objects takes the place of the floor") {
  const std::string behind =
      R"({"a": {"grayScott": {"display": {"layer": "behind"}}}, "m": {"sphere": {}}})";
  const std::string none = R"({"a": {"grayScott": {"display": {"layer": "none"}}}, "m": {"sphere": {}}})";
  CHECK(parsed(none).ground);
  const scene::Scene scene = parsed(behind);
  CHECK(scene.staged);
  CHECK_FALSE(scene.ground);
  CHECK(scene.remarks.empty());
  const std::vector<std::string> said = parsed(behind, R"("ground": {}, )").remarks;
  REQUIRE(said.size() == 1);
  CHECK(said[0].find("the ground hides the picture of \"a\"") != std::string::npos);
  CHECK(parsed(behind, R"("ground": {"visible": false}, )").remarks.empty());
}

TEST_CASE("stage: text without a position stands above the other objects, one above the other") {
  const std::string two = R"({"m": {"sphere": {"radius": 2}}, "t": {"text": {}}, "u": {"text": {}}})";
  const auto boxOf = [](const scene::Scene& scene, std::size_t i) {
    return *scene.objects[i].parameters->framed();
  };
  const scene::Scene scene = parsed(two);
  CHECK(boxOf(scene, 1).min.y > 2);
  CHECK(boxOf(scene, 2).min.y > boxOf(scene, 1).max.y);
  CHECK(boxOf(parsed(two, "", 1), 1).min.y < 1);
  CHECK(boxOf(parsed(R"({"m": {"sphere": {}}, "t": {"text": {"position": [0, 0, 0]}}})"), 1).min.y < 0.1F);
  CHECK(boxOf(parsed(R"({"t": {"text": {}}})"), 0).min.y < 0.1F);
}

TEST_CASE("stage: a camera on an orbit that does not turn is as near as its angle allows") {
  const std::string bar = R"({"m": {"box": {"size": [8, 0.5, 0.5]}}})";
  const auto distance = [&](const char* turn) {
    return parsed(bar, fmt::format(R"("camera": {{"orbit": {{"turn": {}}}}}, )", turn))
        .camera.orbit->distance.at(0);
  };
  const float whole = distance(R"({"keys": [[0, 0], [4, 360]]})");
  CHECK(distance("90") < whole);
  CHECK(distance(R"({"keys": [[0, 80], [4, 100]]})") < whole);
}

TEST_CASE("particles and a body without a key are stars that shine and a figure that walks") {
  const auto stars = [](const char* members) {
    const auto all = parsed(fmt::format(R"({{"p": {{"particles": {{{}}}}}}})", members)).objects;
    return dynamic_cast<const sim::ParticleParameters&>(*all[0].parameters);
  };
  CHECK((stars("").additive && stars("").colorBy == sim::Instances::ColorBy::speed));
  CHECK((stars(R"("look": {"size": 0.2})").additive && stars(R"("look": {"size": 0.2})").size == 0.2F));
  for (const char* solid : {R"("contact": {})", R"("look": {"additive": false})",
                            R"("look": {"shape": "sphere"})", R"("groups": [{}])", R"("emitters": [{}])"})
    CHECK_MESSAGE(!stars(solid).additive, solid);
  const auto all = parsed(R"({"b": {"body": {}}})").objects;
  const auto& body = dynamic_cast<const sim::BodyParameters&>(*all[0].parameters);
  CHECK((body.figure() != nullptr && body.animation == "walk"));
  CHECK_THROWS_AS(parsed(R"({"b": {"body": {}}})", "", 1), UserError);
}

TEST_CASE("life: a size leaves the trail of version 2 as it is") {
  const auto trail = [](const char* life, int version = 2) {
    const scene::Scene scene = parsed(fmt::format(R"({{"l": {{"life": {{{}}}}}}})", life), "", version);
    return dynamic_cast<const sim::LifeParameters&>(*scene.objects[0].parameters).trail;
  };
  CHECK(trail("") == 24);
  CHECK(trail(R"("size": [80, 60])") == 24);
  CHECK(trail(R"("size": [80, 60], "trail": 0)") == 0);
  CHECK(trail(R"("size": [2048, 2048])") == 0);
  CHECK(trail(R"("size": [80, 60])", 1) == 0);
}

TEST_CASE("water: a key of the rain or a colour of the ground leaves the rest of the pond as it is") {
  const auto water = [](const char* members) {
    const scene::Scene scene = parsed(fmt::format(R"({{"w": {{"water": {{{}}}}}}})", members));
    return dynamic_cast<const sim::WaterParameters&>(*scene.objects[0].parameters);
  };
  const sim::WaterParameters pond = water(""), rate = water(R"("rain": {"rate": 5})");
  CHECK(rate.rain->rate == 5);
  CHECK(rate.rain->radius == pond.rain->radius);
  CHECK(rate.rain->duration == pond.rain->duration);
  const sim::WaterParameters red = water(R"("terrain": {"color": [1, 0, 0]})");
  CHECK(red.ground == glm::vec3(1, 0, 0));
  CHECK(red.hills.size() == pond.hills.size());
  CHECK(red.rain->rate == pond.rain->rate);
  CHECK(water(R"("terrain": {"bed": -1})").hills.empty());
  CHECK_FALSE(water(R"("terrain": {"bed": -1})").rain);
}

TEST_CASE("skins of fields with states show their colours unless the scene gives a look") {
  const auto look = [](const char* kind, const char* more = "") {
    return parsed(fmt::format(R"({{"a": {{"{}": {{}}}}, "m": {{"sphere": {{}}, "material": {{"skin":
                                  {{"field": "a"{}}}}}}}}})",
                              kind, more))
        .objects[1]
        .material.skin->look;
  };
  CHECK(look("life") == scene::Skin::Look::map);
  CHECK(look("life", R"(, "look": "spots")") == scene::Skin::Look::spots);
  CHECK(look("life", R"(, "low": [1, 0, 0])") == scene::Skin::Look::leather);
  CHECK(look("grayScott") == scene::Skin::Look::leather);
}

TEST_CASE("a material's colour works, or one line says what has its place") {
  const auto said = [](const std::string& object) { return parsed(R"({"a": )" + object + "}").remarks; };
  const std::vector<std::string> terrain = said(
      R"({"contour": {"image": "textures/gingham.png"}, "material": {"color": "red", "metallic": 1}})");
  REQUIRE(terrain.size() == 1);
  CHECK(terrain[0].find("the colours of its \"map\"; here \"color\"") != std::string::npos);
  CHECK(said(R"({"cave": {}, "material": {"color": "red"}})").size() == 1);
  CHECK(said(R"({"cave": {}, "material": {"texture": "textures/gingham.png"}})").empty());
  const std::string swarm = R"({"particles": {"groups": [{}], "look": {"colorBy": )";
  CHECK(said(swarm + R"("speed"}}, "material": {"color": "red"}})").size() == 1);
  CHECK(said(swarm + R"("material"}}, "material": {"color": "red"}})").empty());
  CHECK(said(R"({"water": {}, "material": {"color": "red"}})").empty());
}

TEST_CASE("one line says that a colour bar explains a field which nothing shows") {
  const auto said = [](const char* layer, const char* more = "") {
    return parsed(fmt::format(R"({{"a": {{"grayScott": {{"display": {{"layer": "{}"}}}}}},
                                   "bar": {{"colorBar": {{"of": "a"}}}}{}}})",
                              layer, more))
        .remarks;
  };
  CHECK(said("over").empty());
  const std::vector<std::string> hidden = said("none");
  REQUIRE(hidden.size() == 1);
  CHECK(hidden[0].find("x.json:2:") != std::string::npos);
  CHECK(hidden[0].find("colorBar \"bar\"") != std::string::npos);
  CHECK(said("none", R"(, "m": {"sphere": {}, "material": {"skin": {"field": "a"}}})").empty());
  CHECK(said("none", R"(, "c": {"contour": {"field": "a"}})").empty());
}

TEST_CASE("one line at the layer says that a scene of fields draws none") {
  const auto said = [](const std::string& kind, const char* more = "") {
    return parsed(fmt::format(R"({{"a": {{"{}": {{"display": {{"layer": "none"}}}}}}{}}})", kind, more))
        .remarks;
  };
  for (const char* kind : {"lenia", "life", "grayScott", "epidemic", "wildfire", "fluid"}) {
    CAPTURE(kind);
    const std::vector<std::string> empty = said(kind);
    REQUIRE(empty.size() == 1);
    CHECK(empty[0].find("x.json:1:") != std::string::npos);
    CHECK(empty[0].find("nothing is drawn: the layer of \"a\" is \"none\"") != std::string::npos);
  }
  CHECK(said("lenia", R"(, "m": {"sphere": {}, "material": {"skin": {"field": "a"}}})").empty());
  CHECK(said("fluid", R"(, "m": {"arrows": {"of": "a"}})").empty());
  CHECK(said("lenia", R"(, "b": {"life": {}})").empty());
}

TEST_CASE("one line at the arrows says that the picture of their fluid hides them") {
  const auto said = [](const char* display) {
    return parsed(
               fmt::format(R"({{"a": {{"fluid": {{"display": {}}}}}, "m": {{"arrows": {{"of": "a"}}}}}})",
                           display))
        .remarks;
  };
  const std::vector<std::string> hidden = said("{}");
  REQUIRE(hidden.size() == 1);
  CHECK(hidden[0].find("x.json:1:") != std::string::npos);
  CHECK(hidden[0].find("and hides \"m\"; give it \"display\"") != std::string::npos);
  CHECK(said(R"({"layer": "none"})").empty());
  CHECK(said(R"({"extent": [0.5, 1, 0]})").empty());
}

TEST_CASE("a field behind all objects keeps the colours of its colour bar, unless the scene has a tone") {
  const std::string field = R"({"a": {"life": {"display": {"layer": "behind"}}})";
  const std::string bar = R"(, "c": {"colorBar": {"of": "a"}}})";
  CHECK(parsed(field + bar).render.tone == scene::Tone::plain);
  CHECK(parsed(field + bar, R"("render": {"tone": "agx"}, )").render.tone == scene::Tone::agx);
  CHECK(parsed(field + bar, "", 1).render.tone == scene::Tone::aces);
  CHECK(parsed(field + "}").render.tone == scene::Tone::aces);
}

TEST_CASE("the camera shows the rectangle of a fluid on which arrows are drawn, beside other objects") {
  const std::string ball = R"(, "b": {"sphere": {"position": [0, 9, 0]}}})";
  const auto box = [&](const std::string& objects, int version = 2) {
    return scene::boxAround(scene::framedObjects(parsed(objects + ball, "", version)));
  };
  for (const char* source :
       {R"("fluid": {"size": [320, 180], "display": {"layer": "none"}})", R"("flow": {"show": "none"})"})
    for (const char* kind : {"arrows", "streamlines"}) {
      const std::string objects =
          fmt::format(R"({{"a": {{{}}}, "m": {{"{}": {{"of": "a", "sheet": true}}}})", source, kind);
      CAPTURE(objects);
      const scene::Box whole = box(objects);
      CHECK(whole.min.y < 8);
      CHECK(whole.max.x - whole.min.x > 2.5F);
      CHECK(box(objects, 1).min.y == 8);
    }
}

TEST_CASE("the camera shows the whole pond beside other objects, and the ground is below it") {
  const std::string beside = R"({"w": {"water": {}}, "b": {"sphere": {"position": [0, 3, 0]}}})";
  const auto box = [](const scene::Scene& scene) { return scene::boxAround(scene::framedObjects(scene)); };
  const scene::Scene scene = parsed(beside, R"("ground": {}, )");
  const float half = 0.5F * 193 * 0.035F;
  CHECK(box(scene).min.x == doctest::Approx(-half));
  CHECK(box(scene).max.z == doctest::Approx(half));
  CHECK(scene.ground->height == doctest::Approx(-0.122F * 2 * half));
  CHECK(scene.ground->height < box(scene).min.y);
  CHECK(box(parsed(R"({"w": {"water": {}}})")).max.x < 0.2F * 2 * half);
  CHECK(box(parsed(beside, "", 1)).max.x < 0.2F * 2 * half);
  CHECK(parsed(beside, R"("ground": {"height": -3}, )").ground->height == -3);
  CHECK(parsed(beside, R"("ground": {}, )", 1).ground->height == -5);
}

}  // namespace simreel::test::stage_second
