// Tests that automatic cameras frame the motion of cloth and particles. A simulated run measures the
// motion, whose expected extent is known in closed form.
#include "sim/world/survey.hpp"

#include "draw/camera.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

using namespace simreel;

namespace {

scene::Scene sceneGoing(const std::string& objects, const std::string& more = "") {
  testContext();
  return scene::parseScene(fmt::format(R"({{"version": 1, {}"objects": {}}})", more, objects), "test.json",
                           {}, sim::kinds());
}

/// Returns a sheet without damping, wind or pins.
std::string looseSheet(float height) {
  return fmt::format(R"({{"sheet": {{"cloth": {{"size": [8, 8], "pins": [], "position": [0, {}, 0],
                        "wind": [0, 0, 0], "damping": 0}}}}}})",
                     height);
}

struct SeenExtent {
  glm::vec3 low{1e9F}, high{-1e9F};
};

SeenExtent wayOf(const scene::Framed& framed) {
  SeenExtent extent;
  for (const glm::vec3& point : framed.points)
    extent = {glm::min(extent.low, point), glm::max(extent.high, point)};
  return extent;
}

}  // namespace

TEST_CASE("survey: a falling sheet is framed from its start to its lowest position") {
  // The sheet falls below height 0, which is outside the extent derived from its parameters.
  scene::Scene scene = sceneGoing(looseSheet(1), R"("time": {"duration": 0.6}, )");
  const sim::Survey survey = sim::surveyMotion(scene);
  CHECK(survey.frames == 36);
  REQUIRE(survey.framed.size() == 1);
  const SeenExtent extent = wayOf(survey.framed[0]);
  CHECK(extent.high.y == doctest::Approx(1).epsilon(1e-6).scale(0));
  const double seconds = 35 / 60.0;
  CHECK(extent.low.y == doctest::Approx(1 - 4.9 * seconds * seconds).epsilon(0.02).scale(0));
  CHECK(extent.low.x == doctest::Approx(-0.35).epsilon(1e-4).scale(0));
  CHECK(survey.framed[0].box.min.y == extent.low.y);
  // A sheet is no longer framed once it has left its expected extent (1 m high) by more than its size.
  scene::Scene longer = sceneGoing(looseSheet(1), R"("time": {"duration": 5}, )");
  const SeenExtent kept = wayOf(sim::surveyMotion(longer).framed[0]);
  CHECK(kept.low.y > -1.01F);
  CHECK(kept.low.y < -0.4F);
}

TEST_CASE("survey: a jet is framed up to its top, and one stray particle is ignored") {
  scene::Scene scene = sceneGoing(R"({"jet": {"particles": {"method": "none", "acceleration": [0, -8, 0],
    "look": {"size": 0.001}, "emitters": [{"velocity": [0, 4, 0], "spread": 0, "speedVariation": 0, "lifetime": 1}]}}})",
                                  R"("time": {"start": 2, "duration": 1}, )");
  const SeenExtent extent = wayOf(sim::surveyMotion(scene).framed.at(0));
  // The jet reaches a height of v^2 / (2 g). It is complete, because the pre-roll is long enough.
  CHECK(extent.high.y == doctest::Approx(1).epsilon(0.02).scale(0));
  CHECK(std::abs(extent.high.x) < 0.01F);
  scene::Scene stray =
      sceneGoing(R"({"jet": {"particles": {"method": "none", "look": {"size": 0.001}, "groups": [
    {"count": 1000, "radius": 0.5}, {"count": 1, "radius": 0.5, "position": [1.5, 0, 0]}]}}})");
  CHECK(wayOf(sim::surveyMotion(stray).framed.at(0)).high.x < 0.6F);
}

TEST_CASE("survey: drops that fall through a ground without a height are not framed") {
  const auto lowest = [](const std::string& ground) {
    scene::Scene scene = sceneGoing(R"({"jet": {"particles": {"method": "none", "acceleration": [0, -8, 0],
      "look": {"size": 0.001}, "emitters": [{"velocity": [0, 4, 0], "radius": 0, "lifetime": 2}]}}})",
                                    R"("time": {"duration": 2}, )" + ground);
    return wayOf(sim::surveyMotion(scene).framed.at(0)).low.y;
  };
  CHECK(lowest("") < -2);
  CHECK(lowest(R"("ground": {}, )") >= -0.0005F);  // half a particle
  CHECK(lowest(R"("ground": {"height": 0}, )") < -2);
}

TEST_CASE("survey: a motion fills the picture and stays inside it at every frame") {
  for (const char* more : {"", R"("stage": false, )"}) {
    scene::Scene scene =
        sceneGoing(R"({"sheet": {"cloth": {"size": [16, 16], "pins": [], "position": [0, 2, 0]}},
                       "ball": {"sphere": {"radius": 0.6}}})",
                   std::string(more) + R"("time": {"duration": 1}, )");
    const glm::vec3 before = scene.camera.position.at(0);
    const sim::MotionFraming framing = sim::frameMotion(scene);
    CHECK(framing.camera.size() == 3);
    CHECK(scene.camera.position.at(0) != before);
    const draw::View view = draw::viewAt(scene.camera, 0, scene.render.size, {});
    glm::vec2 low(9), high(-9);
    sim::World world(scene);
    for (int frame = 0; frame < scene.frameCount(); ++frame) {
      world.advanceTo(frame);
      const sim::PointTable table = world.object(0).points();
      for (std::size_t i = 0; i < table.values.size(); i += table.columns.size()) {
        const glm::vec4 seen =
            view.viewProjection * glm::vec4(table.values[i], table.values[i + 1], table.values[i + 2], 1);
        low = glm::min(low, glm::vec2(seen) / seen.w);
        high = glm::max(high, glm::vec2(seen) / seen.w);
      }
    }
    CHECK(low.x > -0.95F);
    CHECK(high.x < 0.95F);
    CHECK(high.y < 0.95F);
    CHECK(low.y > -0.95F);
    CHECK(std::max({high.x - low.x, high.y - low.y}) > 1.2F);
    // The scene is already framed, so a second call does nothing.
    CHECK(sim::frameMotion(scene).remark.empty());
  }
}

TEST_CASE("survey: fast numerics give the same camera") {
  const std::string sheet = R"({"sheet": {"cloth": {"size": [12, 12]}}})";
  scene::Scene exact = sceneGoing(sheet), fast = sceneGoing(sheet, R"("numerics": "fast", )");
  CHECK(sim::frameMotion(exact).camera == sim::frameMotion(fast).camera);
  CHECK(fast.numerics == scene::Numerics::fast);
}

// The stage needs the extent of the motion even if the scene places the camera.
TEST_CASE("survey: the ground lies under the moving object for any camera") {
  scene::Scene free = sceneGoing(looseSheet(1)),
               placed = sceneGoing(looseSheet(1), R"("camera": {"position": [1, 2, 6]}, )");
  const float before = free.ground->height;
  CHECK(sim::needsSurvey(placed));
  CHECK(sim::frameMotion(free).camera.size() >= 3);
  CHECK(sim::frameMotion(placed).remark.empty());
  CHECK(free.ground->height < before - 0.05F);
  CHECK(placed.ground->height == free.ground->height);
  CHECK(placed.camera.position.at(0) == glm::vec3(1, 2, 6));
  CHECK_FALSE(sim::needsSurvey(placed));
}

TEST_CASE("survey: no survey runs for expensive scenes, placed cameras or static scenes") {
  scene::Scene scene = sceneGoing(looseSheet(1));
  const sim::Survey none = sim::surveyMotion(scene, {}, 1000);
  CHECK(none.frames == 0);
  const glm::vec3 before = scene.camera.position.at(0);
  sim::frameSurvey(scene, none);
  CHECK(scene.camera.position.at(0) == before);
  CHECK(sim::needsSurvey(scene));
  CHECK_FALSE(
      sim::needsSurvey(sceneGoing(looseSheet(1), R"("stage": false, "camera": {"target": [0, 1, 0]}, )")));
  CHECK_FALSE(sim::needsSurvey(sceneGoing(R"({"ball": {"sphere": {}}})")));
  scene::Scene large = sceneGoing(R"({"sheet": {"cloth": {"size": [400, 400]}}})");
  const sim::MotionFraming framing = sim::frameMotion(large);
  CHECK(framing.camera.empty());
  CHECK(framing.remark.find("would take too long") != std::string::npos);
}
