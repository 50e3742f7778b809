// Tests the sample points of a lens, and the shift of the picture between them.
#include "draw/lens.hpp"

#include "draw/exact/exact_view.hpp"

#include <cmath>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

glm::vec2 pixelOf(const shader::ExactView& view, glm::vec3 place) {
  const glm::vec3 from = place - glm::vec3(view.eye);
  return glm::vec2(glm::dot(from, glm::vec3(view.across)), glm::dot(from, glm::vec3(view.down))) /
         glm::dot(from, glm::vec3(view.forward));
}

scene::Camera tilted() {
  scene::Camera camera;
  camera.position = glm::vec3(1, 2, 5);
  camera.target = glm::vec3(0.3F, 0.4F, -1);
  camera.roll = 20.0F;
  camera.lens.emplace();
  return camera;
}

}  // namespace

TEST_CASE("lens: sample points cover a disc evenly, and also polygons") {
  for (const int count : {2, 7, 32, 1000}) {
    const auto points = draw::openingPoints(count, 0);
    REQUIRE(points.size() == static_cast<std::size_t>(count));
    int within = 0;
    for (const glm::vec2& at : points) {
      CHECK(glm::length(at) < 1);
      within += glm::length(at) < 0.5F ? 1 : 0;
    }
    CHECK(std::abs(within - count / 4) <= 1);
  }
  const auto round = draw::openingPoints(1000, 0);
  for (const int blades : {3, 4, 6, 16}) {
    CAPTURE(blades);
    const auto points = draw::openingPoints(1000, blades);
    REQUIRE(points.size() == 1000);
    glm::vec2 sum(0), squares(0);
    float top = -1;
    for (const glm::vec2& at : points) {
      sum += at / 1000.0F;
      squares += at * at / 1000.0F;
      top = std::max(top, at.y);
    }
    CHECK(glm::length(sum) < 0.01F);
    // Mean square along each axis of a regular n-gon with corners on the unit circle, which is (2 + cos(2
    // pi / n)) / 12.
    const float mean = (2 + std::cos(6.2831853F / static_cast<float>(blades))) / 12;
    CHECK(squares.x == doctest::Approx(mean).epsilon(0.03));
    CHECK(squares.y == doctest::Approx(mean).epsilon(0.03));
    CHECK(top > 0.93F);  // The farthest point is near a corner of the polygon.
  }
}

TEST_CASE(
    "lens: the aperture follows focal length and f-number, and the focus is the camera's target by "
    "default") {
  scene::Camera camera = tilted();
  camera.lens->fNumber = 1.4F;
  const glm::ivec2 size(91, 67);
  const draw::View view = draw::viewAt(camera, 0, size, {});
  const auto points = draw::lensPoints(camera, view, 0);
  REQUIRE(points.size() == 32);
  float radius = 0;
  for (const draw::LensPoint& point : points) {
    radius = std::max(radius, glm::length(point.aside));
    CHECK(std::abs(glm::dot(point.aside, view.forward)) < 1e-7F);
    CHECK(point.focus == doctest::Approx(glm::length(view.target - view.eye)));
  }
  // The focal length is 12 mm / tan(20 degrees) = 32.97 mm. The lens radius is half of it divided by 1.4.
  CHECK(radius == doctest::Approx(0.03297 / 2.8).epsilon(0.01));
  camera.lens->focus = 3.5F;
  CHECK(draw::lensPoints(camera, view, 0).front().focus == 3.5F);
  camera.lens.reset();
  REQUIRE(draw::lensPoints(camera, view, 0).size() == 1);
  CHECK(draw::lensPoints(camera, view, 0).front().aside == glm::vec3(0));
}

TEST_CASE(
    "lens: points in focus do not move, other points move by aperture, distance and focus, and rays "
    "agree") {
  const scene::Camera camera = tilted();
  const glm::ivec2 size(91, 67);
  const draw::View view = draw::viewAt(camera, 0, size, {});
  const glm::vec3 right = glm::normalize(view.right), up = glm::normalize(view.up);
  const shader::ExactView middle = draw::exactView(view, camera, size);
  const glm::vec2 perMetre = 0.5F * glm::vec2(size) / view.reach;  // pixels per metre at a distance of 1 m
  std::mt19937 random(3);
  std::uniform_real_distribution<float> any(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const float focus = 2 + any(random), distance = 3 + 2 * any(random);
    const glm::vec2 aside(0.2F * any(random), 0.2F * any(random));
    const auto seen = draw::exactView(view, camera, size, {aside.x * right + aside.y * up, focus});
    const auto placeAt = [&](float depth) {
      return view.eye + depth * (view.forward + any(random) * view.right + any(random) * view.up);
    };
    const glm::vec3 sharp = placeAt(focus), other = placeAt(distance);
    CHECK(glm::length(pixelOf(seen, sharp) - pixelOf(middle, sharp)) < 1e-2F);
    const float by = 1 / focus - 1 / distance;
    const glm::vec2 moved = pixelOf(seen, other) - pixelOf(middle, other);
    CHECK(moved.x == doctest::Approx(aside.x * by * perMetre.x).epsilon(1e-3));
    CHECK(moved.y == doctest::Approx(-aside.y * by * perMetre.y).epsilon(1e-3));
    const glm::vec2 pixel = pixelOf(seen, other);
    const glm::vec3 ray =
        glm::vec3(seen.ray) + pixel.x * glm::vec3(seen.rayAcross) + pixel.y * glm::vec3(seen.rayDown);
    CHECK(glm::length(glm::vec3(seen.eye) + distance * ray - other) < 1e-4F * distance);
  }
}
