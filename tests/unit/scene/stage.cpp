// Tests that the stage supplies the surroundings that a scene leaves out.
#include "draw/camera.hpp"
#include "draw/frame_values.hpp"
#include "scene/framing.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"
#include "source_folder.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec4.hpp>

using namespace simreel;

namespace {

scene::Scene parsed(const std::string& objects, const std::string& more = "") {
  return scene::parseScene(fmt::format(R"({{"version": 1, {}"objects": {}}})", more, objects),
                           sourceFolder() + "/assets/scenes/x.json", {}, sim::kinds());
}

const std::string ball = R"({"m": {"sphere": {}}})";

}  // namespace

TEST_CASE("stage: a one-line scene gets ground, three-sided light and a colour") {
  const scene::Scene scene = parsed(ball);
  CHECK(scene.staged);
  CHECK(scene.ground);
  CHECK(scene.ground->height == doctest::Approx(-1).epsilon(0.01));
  CHECK(scene.ground->height < -1);
  CHECK(scene.sun.diameter > 1);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.objects[0].material.color != scene::Material().color);
  // The lamp shines from behind the objects, the sun from the camera's side.
  const glm::vec3 eye = scene.camera.position.at(0);
  const glm::vec3 lamp = scene.lights[0].position.at(0);
  const glm::vec3 sun = scene.sun.direction.at(0);
  CHECK(lamp.x * eye.x + lamp.z * eye.z < 0);
  CHECK(sun.x * eye.x + sun.z * eye.z > 0);
}

TEST_CASE("stage: an empty group for sun, sky, ground or lights keeps the values of the stage") {
  const scene::Scene plain = parsed(ball);
  for (const char* given : {"sun", "sky", "ground", "lights"}) {
    CAPTURE(given);
    const scene::Scene scene = parsed(ball, fmt::format(R"("{}": {{}}, )", given));
    CHECK(scene.staged);
    CHECK(scene.render.quality == plain.render.quality);
    CHECK(scene.ground->height == plain.ground->height);
    CHECK(scene.ground->color == plain.ground->color);
    CHECK(scene.ground->solid == (std::string(given) == "ground"));
    CHECK(scene.lights.size() == 1);
    CHECK(scene.sun.diameter == plain.sun.diameter);
    CHECK(scene.sun.direction.at(0) == plain.sun.direction.at(0));
    CHECK(scene.sky.zenith.at(0) == plain.sky.zenith.at(0));
    CHECK(scene.objects[0].material.color == plain.objects[0].material.color);
    CHECK(scene.camera.position.at(0) == plain.camera.position.at(0));
    CHECK(scene.camera.fieldOfView.at(0) == plain.camera.fieldOfView.at(0));
  }
}

TEST_CASE("stage: each value in the scene replaces only that value of the stage") {
  const scene::Scene plain = parsed(ball);
  const scene::Scene scene =
      parsed(ball, R"("sun": {"intensity": 1}, "sky": {"zenith": [1, 0, 0]}, "ground": {"color": [0, 1, 0]},
               "lights": {"lamp": {"position": [0, 3, 0]}}, )");
  CHECK(scene.sun.intensity.at(0) == 1);
  CHECK(scene.sun.direction.at(0) == plain.sun.direction.at(0));
  CHECK(scene.sky.zenith.at(0) == glm::vec3(1, 0, 0));
  CHECK(scene.sky.horizon.at(0) == plain.sky.horizon.at(0));
  CHECK(scene.ground->color == glm::vec3(0, 1, 0));
  CHECK(scene.ground->fadeEnd == plain.ground->fadeEnd);
  REQUIRE(scene.lights.size() == 2);
  CHECK(scene.lights[0].name == "lamp");
  CHECK(scene.lights[1].position.at(0) == plain.lights[0].position.at(0));
  // A lamp named "rim" replaces the stage's lamp.
  CHECK(parsed(ball, R"("lights": {"rim": {"position": [0, 3, 0]}}, )").lights.size() == 1);
}

TEST_CASE("stage: a sky picture replaces the light of the sun and keeps the floor") {
  const scene::Scene scene = parsed(ball, R"("sky": {"picture": "textures/studio.hdr"}, )");
  CHECK(scene.staged);
  CHECK(scene.sun.intensity.at(0) == 0);
  CHECK(scene.ground.has_value());
}

TEST_CASE("stage: its floor is left out if the camera is below it, and a ground of the scene stays") {
  const auto visible = [](const std::string& members) {
    const scene::Scene scene = parsed(ball, members);
    REQUIRE(scene.ground);
    return scene.ground->visible;
  };
  CHECK(visible(R"("camera": {"position": [0, 0.4, 6]}, )"));
  CHECK_FALSE(visible(R"("camera": {"position": [0, -3, 6]}, )"));
  CHECK_FALSE(visible(R"("camera": {"orbit": {"elevation": -30}}, )"));
  CHECK(visible(R"("camera": {"orbit": {"elevation": 30}}, )"));
  CHECK(visible(R"("camera": {"position": [0, -3, 6]}, "ground": {}, )"));
}

TEST_CASE("stage: false gives the plain defaults") {
  const scene::Scene scene = parsed(ball, R"("stage": false, )");
  CHECK_FALSE(scene.staged);
  CHECK_FALSE(scene.ground.has_value());
  CHECK(scene.lights.empty());
  CHECK(scene.sun.diameter == 0);
  CHECK(scene.sun.intensity.at(0) == scene::Sun().intensity.at(0));
  CHECK(scene.sky.zenith.at(0) == scene::Sky().zenith.at(0));
  CHECK(scene.objects[0].material.color == scene::Material().color);
  CHECK(scene.camera.fieldOfView.at(0) == scene::Camera().fieldOfView.at(0));
}

TEST_CASE("stage: every preset has different light, and a backdrop colours floor and background") {
  std::set<float> heights;
  for (const char* preset :
       {"studio", "daylight", "overcast", "sunset", "night", "void", "paper", "blueprint"}) {
    CAPTURE(preset);
    const scene::Scene scene = parsed(ball, fmt::format(R"("stage": "{}", )", preset));
    CHECK(scene.staged);
    CHECK(scene.ground.has_value() == (std::string(preset) != "void"));
    heights.insert(scene.sky.horizon.at(0).z + 0.001F * scene.sun.intensity.at(0));
  }
  CHECK(heights.size() == 8);
  const scene::Scene same = parsed(ball, R"("stage": true, )");
  CHECK(same.sun.intensity.at(0) == parsed(ball, R"("stage": {"preset": "studio"}, )").sun.intensity.at(0));
  const scene::Scene red = parsed(ball, R"("stage": {"backdrop": [0.4, 0, 0], "palette": "grey"}, )");
  CHECK(red.sky.ground.at(0) == glm::vec3(0.4F, 0, 0));
  CHECK(red.ground->color.y == 0);
  const glm::vec3 color = red.objects[0].material.color;
  CHECK(color.x == color.z);
}

TEST_CASE("stage: cameras and materials of the scene are kept") {
  const scene::Scene placed = parsed(ball, R"("camera": {"position": [1, 2, 9]}, )");
  CHECK(placed.staged);
  CHECK(placed.camera.position.at(0) == glm::vec3(1, 2, 9));
  CHECK(placed.camera.fieldOfView.at(0) == scene::Camera().fieldOfView.at(0));
  const scene::Scene wide = parsed(ball, R"("camera": {"fieldOfView": 70}, )");
  CHECK(wide.camera.fieldOfView.at(0) == 70);
  const scene::Scene painted = parsed(
      R"({"m": {"sphere": {}, "material": {"color": [0, 0, 1]}}, "n": {"sphere": {}, "material": {"roughness": 1}},
          "glass": {"sphere": {}, "material": {"transmission": 1}}})");
  CHECK(painted.objects[0].material.color == glm::vec3(0, 0, 1));
  CHECK(painted.objects[0].material.roughness < 0.5F);
  CHECK(painted.objects[1].material.color != scene::Material().color);
  CHECK(painted.objects[1].material.roughness == 1);
  CHECK(painted.objects[2].material.color == glm::vec3(1));
}

TEST_CASE("stage: scenes of fields or landscapes get no stage by default") {
  CHECK_FALSE(parsed(R"({"m": {"life": {}}})").staged);
  CHECK_FALSE(parsed(R"({"m": {"water": {}}})").staged);
  const scene::Scene asked = parsed(R"({"m": {"water": {}}})", R"("stage": "sunset", )");
  CHECK(asked.staged);
  CHECK_FALSE(asked.ground.has_value());  // The terrain serves as the floor.
}

TEST_CASE("stage: neighbouring objects get different colours, and emissive objects a dark stage") {
  const scene::Scene two = parsed(R"({"a": {"sphere": {}}, "b": {"sphere": {}}})");
  CHECK(two.objects[0].material.color != two.objects[1].material.color);
  const scene::Scene lawn = parsed(R"({"a": {"mesh": {"shape": "grass"}}, "b": {"mesh": {}}})");
  CHECK(lawn.objects[0].material.color.y >
        2 * lawn.objects[0].material.color.x);  // The green comes from the object itself, not from the
                                                // palette.
  CHECK(lawn.objects[1].material.color == two.objects[1].material.color);
  const char* cloud = R"({{"a": {{"particles": {{"groups": [{{}}], "look": {{"additive": {}}}}}}}}})";
  const scene::Scene dark = parsed(fmt::format(fmt::runtime(cloud), true));
  const scene::Scene bright = parsed(fmt::format(fmt::runtime(cloud), false));
  CHECK(dark.sky.ground.at(0).x < 0.05F);
  CHECK(bright.sky.ground.at(0).x > 0.3F);
}

TEST_CASE("stage: sunlit ground is as bright as the background it fades into") {
  for (const bool dark : {false, true}) {
    const scene::Scene scene = parsed(
        fmt::format(R"({{"a": {{"particles": {{"groups": [{{}}], "look": {{"additive": {}}}}}}}}})", dark));
    const shader::Frame frame = draw::frameValues(scene, {64, 36}, 0, {});
    for (int i = 0; i < 3; ++i)
      CHECK(frame.groundColor[i] * (frame.sunLight[i] * frame.sunDirection.y + frame.ambientUp[i]) ==
            doctest::Approx(frame.nadir[i]).epsilon(1e-4).scale(0));
  }
}

TEST_CASE("stage: the objects are centred and fill the picture") {
  for (const char* size : {"[640, 360]", "[300, 900]"}) {
    const scene::Scene scene =
        parsed(R"({"a": {"capsule": {"position": [7, 3, 1]}}, "b": {"sphere": {"position": [9, 3, 0]}}})",
               fmt::format(R"("render": {{"size": {}}}, )", size));
    const draw::View view = draw::viewAt(scene.camera, 0, scene.render.size, {});
    glm::vec2 low(9), high(-9);
    // The points are on the outline of the sphere and at the ends of the rod.
    for (int i = 0; i < 4000; ++i) {
      const float turn = 0.6180340F * 6.2831853F * static_cast<float>(i);
      const float y = -1 + (static_cast<float>(i) + 0.5F) / 2000;
      const float r = std::sqrt(1 - y * y);
      const glm::vec3 way(r * std::cos(turn), y, r * std::sin(turn));
      for (const glm::vec3& point :
           {glm::vec3(9, 3, 0) + way, glm::vec3(7, 4, 1) + 0.1F * way, glm::vec3(7, 2, 1) + 0.1F * way}) {
        const glm::vec4 seen = view.viewProjection * glm::vec4(point, 1);
        low = glm::min(low, glm::vec2(seen) / seen.w);
        high = glm::max(high, glm::vec2(seen) / seen.w);
      }
    }
    CHECK(std::max(high.x, high.y) < 0.82F);
    CHECK(std::max(high.x, high.y) > 0.7F);
    CHECK(std::abs(low.x + high.x) < 0.1F);
    CHECK(std::abs(low.y + high.y) < 0.1F);
  }
}
