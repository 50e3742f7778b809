// Tests cameras that orbit their target.
#include "draw/camera.hpp"

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

TEST_CASE("orbit: turn, elevation and distance give the camera position") {
  scene::Orbit orbit;
  orbit.distance = 4.0F;
  orbit.elevation = 0.0F;
  const glm::vec3 target(1, 2, 3);
  const auto eye = [&] { return draw::orbitPose(target, orbit, 0).eye - target; };
  CHECK(glm::length(eye() - glm::vec3(0, 0, 4)) < 1e-5F);
  orbit.turn = 90.0F;
  CHECK(glm::length(eye() - glm::vec3(4, 0, 0)) < 1e-5F);
  orbit.turn = -90.0F;
  CHECK(glm::length(eye() - glm::vec3(-4, 0, 0)) < 1e-5F);
  orbit.elevation = 30.0F;
  orbit.turn = 180.0F;
  CHECK(glm::length(eye() - glm::vec3(0, 2, -4 * std::sqrt(0.75F))) < 1e-5F);
}

TEST_CASE("orbit: the camera looks at the target and turns with time") {
  scene::Camera camera;
  camera.orbit.emplace();
  camera.target = glm::vec3(0, 1, 0);
  camera.orbit->turn = scene::Animated<float>({{0, 0.0F}, {2, 360.0F}}, scene::Ease::linear);
  camera.orbit->distance = 5.0F;
  for (const double time : {0.0, 0.3, 1.0, 1.7}) {
    const draw::View view = draw::viewAt(camera, time, {320, 180}, {});
    CHECK(glm::length(view.eye - view.target) == doctest::Approx(5));
    CHECK(view.eye.x == doctest::Approx(5 * std::cos(0.3490659F) * std::sin(3.14159265 * time)).scale(1));
    CHECK(glm::dot(view.forward, glm::normalize(view.target - view.eye)) == doctest::Approx(1));
  }
}

TEST_CASE("track: the camera looks at the object's centre and moves with it on an orbit") {
  scene::Camera camera;
  camera.track.emplace();
  camera.track->object = "ball";
  camera.track->offset = glm::vec3(0, 0.5F, 0);
  camera.position = glm::vec3(3, 1, 4);
  const std::string name = "ball", other = "cup";
  const sim::Drawables drawables{.places = {{&other, glm::vec3(9)}, {&name, glm::vec3(1, 2, -1)}}};
  const glm::vec3 target(1, 2.5F, -1);
  draw::View view = draw::viewAt(camera, 0, {320, 180}, drawables);
  CHECK(view.target == target);
  CHECK(view.eye == glm::vec3(3, 1, 4));
  CHECK(glm::length(view.forward - glm::normalize(target - view.eye)) < 1e-6F);
  camera.orbit.emplace();
  camera.orbit->elevation = 0.0F;
  camera.orbit->distance = 2.0F;
  view = draw::viewAt(camera, 0, {320, 180}, drawables);
  CHECK(glm::length(view.eye - (target + glm::vec3(0, 0, 2))) < 1e-5F);
  CHECK_THROWS_WITH(static_cast<void>(draw::viewAt(camera, 1.5, {320, 180}, {})),
                    "the camera looks at \"ball\", which has no place at 1.5 s");
}
