// Tests the scenes that are generated for glTF files: motions and lights.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/body/figure.hpp"
#include "sim/body/model_scene.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"
#include "unit/polygons/float_gltf.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace simreel::test::polygons_models {

namespace {

using Json = nlohmann::json;
using Document = FloatGltf;

const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

Json sceneAround(Document& d) {
  const TemporaryFile file("model.gltf", d.text());
  return Json::parse(sim::sceneAroundModel(file.path()));
}

/// Returns a triangle whose node moves from 0 to 2 m along x within 3 s.
Document moving() {
  Document d;
  d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", d.add(triangle, "VEC3", 3)}}}}}}}};
  const int times = d.add({0, 3}, "SCALAR", 1), places = d.add({0, 0, 0, 2, 0, 0}, "VEC3", 3);
  d.json["animations"] = {
      {{"name", "slide"},
       {"samplers", {{{"input", times}, {"output", places}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  return d;
}

}  // namespace

TEST_CASE("glTF models with a moving node are bodies, also without a skin") {
  Document d = moving();
  const Json scene = sceneAround(d);
  CHECK(scene["objects"]["model"]["body"]["animation"] == "slide");
  CHECK(scene["time"]["duration"] == 3);
  CHECK_FALSE(scene.contains("sun"));
  const TemporaryFile file("moving.gltf", d.text());
  const sim::Figure figure = sim::loadFigure(file.path());
  CHECK(figure.joints.size() == 1);
  CHECK(figure.animations.at(0).channels.size() == 1);
  d.json.erase("animations");
  CHECK(sceneAround(d)["objects"]["model"].contains("mesh"));
  const TemporaryFile still("still.gltf", d.text());
  CHECK_THROWS_WITH_AS(static_cast<void>(sim::loadFigure(still.path())),
                       doctest::Contains("has neither a skin nor a moving mesh"), UserError);
}

TEST_CASE("glTF lights shine from their nodes, and their sum is brought to 5 lx if it is out of range") {
  Document d;
  const int place = d.add(triangle, "VEC3", 3);
  d.json["accessors"][0]["min"] = {0, 0, 0};
  d.json["accessors"][0]["max"] = {1, 1, 0};
  d.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", place}}}}}}}};
  const auto use = [](int light) { return Json{{"KHR_lights_punctual", {{"light", light}}}}; };
  // The sun's node has a quarter turn about x, so that -z becomes -y.
  d.json["nodes"] = {{{"mesh", 0}, {"children", {1, 2}}, {"translation", {10, 0, 0}}},
                     {{"name", "lamp"}, {"translation", {0.5, 0.5, 2}}, {"extensions", use(0)}},
                     {{"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}, {"extensions", use(1)}}};
  d.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"intensity", 400},
       {"color", {1, 0.5, 0}},
       {"range", 9},
       {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}},
      {{"type", "directional"}, {"intensity", 100}}};
  const Json scene = sceneAround(d);
  const Json& lamp = scene["lights"]["lamp"];
  // 400 cd at a distance of 2 m and 100 lx are together 200 lx at the middle (10.5, 0.5, 0). The scale
  // factor is 5 / 200.
  CHECK(lamp["intensity"].get<double>() == doctest::Approx(10));
  CHECK(lamp["position"] == Json({10.5, 0.5, 2.0}));
  CHECK(lamp["spot"]["target"] == Json({10.5, 0.5, 1.0}));
  CHECK(lamp["spot"]["angle"].get<double>() == doctest::Approx(57.2957795));
  CHECK(lamp["spot"]["softness"].get<double>() == doctest::Approx(0.5));
  CHECK(lamp["range"] == 9);
  CHECK(lamp["color"] == Json({1.0, 0.5, 0.0}));
  CHECK(scene["sun"]["intensity"].get<double>() == doctest::Approx(2.5));
  CHECK(scene["sun"]["direction"][1].get<double>() == doctest::Approx(1));
  d.json["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 8;
  d.json["extensions"]["KHR_lights_punctual"]["lights"][1]["intensity"] = 1;
  CHECK(sceneAround(d)["lights"]["lamp"]["intensity"] == 8);
  const TemporaryFile file("lit.gltf", d.text());
  const scene::Scene parsed = scene::loadScene(file.path(), {}, sim::kinds());
  CHECK(std::any_of(parsed.lights.begin(), parsed.lights.end(),
                    [](const scene::Light& light) { return light.name == "lamp"; }));
}

}  // namespace simreel::test::polygons_models
