// Tests motions of bones by comparison with closed forms.
#include "sim/body/motion.hpp"
#include "sim/nodes/sample.hpp"
#include "unit/figure_text.hpp"
#include "unit/help.hpp"

#include <cmath>
#include <functional>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

sim::BodyParameters tubeBody(const test::TemporaryFile& file, const char* animation) {
  sim::BodyParameters p;
  p.file = file.path();
  p.animation = animation;
  return p;
}

/// Returns the world position of a point that is given in the coordinates of a bone.
glm::dvec3 pointAt(const sim::BodyMotion& motion, const char* bone, glm::dvec3 point, double time) {
  return glm::dvec3(motion.nodeAt(motion.boneNamed(bone), time) * glm::dvec4(point, 1));
}

void checkNear(const glm::dvec3& got, const glm::dvec3& expected, double slack = 5e-7) {
  for (int k = 0; k < 3; ++k) CHECK(got[k] == doctest::Approx(expected[k]).epsilon(slack).scale(1));
}

}  // namespace

TEST_CASE("slerp follows the sine formula along the shorter arc") {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, -2, 0.5));
  const auto turned = [&](double degrees) {
    const double half = degrees * 0.008726646259971648;
    return glm::dquat(std::cos(half), axis * std::sin(half));
  };
  for (const double angle : {0.0, 1e-6, 1.0, 60.0, 120.0, 179.0, 179.999, 200.0, 359.0})
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
      const double way = angle > 180 ? angle - 360 : angle;
      const glm::dquat got = sim::slerp(turned(30), turned(30 + angle), u);
      const glm::dquat expected = turned(30 + way * u);
      const double cosine =
          got.w * expected.w + got.x * expected.x + got.y * expected.y + got.z * expected.z;
      CHECK(std::abs(std::abs(cosine) - 1) < 1e-11);
      CHECK(std::abs(got.w * got.w + got.x * got.x + got.y * got.y + got.z * got.z - 1) < 1e-12);
    }
}

TEST_CASE("body: linear, stepped and cubic motions equal their closed form") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  const sim::BodyMotion bend("tube", tubeBody(file, "bend"));
  for (const double t : {0.0, 0.1, 0.25, 0.5, 0.6, 1.0}) {
    // The bone rotates at 180 degrees per second to 90 degrees and back, and moves sideways at 2 m/s and
    // back.
    const double share = t < 0.5 ? 2 * t : 2 - 2 * t;
    const double angle = share * 1.5707963267948966;
    checkNear(pointAt(bend, "high", {0, 0, 0}, t), {share, 0.5, 0});
    checkNear(pointAt(bend, "tip", {0, 0, 0}, t),
              {share - 0.5 * std::sin(angle), 0.5 + 0.5 * std::cos(angle), 0});
  }
  const sim::BodyMotion stepped("tube", tubeBody(file, "step"));
  checkNear(pointAt(stepped, "tip", {0, 0, 0}, 0.49), {0, 1, 0});
  checkNear(pointAt(stepped, "tip", {0, 0, 0}, 0.51), {-0.5, 0.5, 0});
  const sim::BodyMotion curve("tube", tubeBody(file, "curve"));
  for (const double t : {0.0, 0.2, 0.4, 0.5, 0.8}) {
    const double u = t < 0.5 ? 2 * t : 2 * t - 1;
    const double from = t < 0.5 ? 0.5 : 0.7;
    const double to = t < 0.5 ? 0.7 : 0.5;
    const double ease = 3 * u * u - 2 * u * u * u;
    // Both tangents are equal, and the interval is half a second.
    const double tangents = 0.5 * (u - 3 * u * u + 2 * u * u * u);
    checkNear(pointAt(curve, "high", {0, 0, 0}, t),
              {tangents, from + (to - from) * ease + 2 * tangents, 3 * tangents}, 1e-6);
  }
}

TEST_CASE("body: loop, end, start offset and speed of a motion work") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  auto p = tubeBody(file, "bend");
  const auto aside = [&](double time) {
    return pointAt(sim::BodyMotion("tube", p), "low", {0, 0, 0}, time).x;
  };
  CHECK(aside(3.25) == doctest::Approx(0.5));
  CHECK(aside(-0.75) == doctest::Approx(0.5));
  p.speed = 2;
  CHECK(aside(0.125) == doctest::Approx(0.5));
  p.speed = -1;
  CHECK(aside(0.9) == doctest::Approx(0.2));
  p.speed = 1;
  p.start = 0.1;
  CHECK(aside(0) == doctest::Approx(0.2));
  p.loop = false;
  p.start = 0;
  CHECK(aside(7) == doctest::Approx(0));
  CHECK(aside(-7) == doctest::Approx(0));
}

TEST_CASE("body: the scene places the body and rotates bones on top of the motion") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  auto p = tubeBody(file, "bend");
  p.position = glm::vec3(1, 2, 3);
  p.rotation = glm::vec3(0, 90, 0);  // The rotation turns x to -z.
  p.scale = 2.0F;
  checkNear(pointAt(sim::BodyMotion("tube", p), "high", {0, 0, 0}, 0.5), {1, 3, 1}, 1e-6);
  auto keyed = tubeBody(file, "");
  keyed.bones.push_back(
      {"high",
       scene::Animated<glm::vec3>({{0, glm::vec3(0)}, {1, glm::vec3(0, 0, -90)}}, scene::Ease::linear),
       glm::vec3(0, 0.25F, 0)});
  const sim::BodyMotion motion("tube", keyed);
  checkNear(pointAt(motion, "tip", {0, 0, 0}, 0), {0, 1.25, 0}, 1e-6);
  checkNear(pointAt(motion, "tip", {0, 0, 0}, 1), {0.5, 0.75, 0}, 1e-6);
}

TEST_CASE("body: times that differ by rounding give the same bits") {
  const test::TemporaryFile file("tube.gltf", test::tubeText().text());
  const sim::BodyMotion motion("tube", tubeBody(file, "bend"));
  for (int frame = 0; frame < 300; ++frame) {
    const double one = frame / 60.0 + 1.0 / 60.0;
    const double other = (frame + 1) / 60.0;
    CHECK(motion.rowsAt(one) == motion.rowsAt(other));
  }
}
