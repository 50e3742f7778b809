// Tests the haze's shader file on the CPU by comparison with closed forms in double precision.
#include "draw/exact/exact_view.hpp"
#include "draw/frame_values.hpp"
#include "draw/picture_code.hpp"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

using namespace simreel::shader;  // NOLINT: the model is written in GLSL's names
#define FUNCTION inline
#define precise
#define EXACT_PICTURE
#define HAZE 1
struct HazeModel {
  Frame frame;
  ExactView view;
#include "glsl/draw/exact/haze.glsl"
#include "glsl/draw/sky.glsl"
};
#undef HAZE
#undef EXACT_PICTURE
#undef precise
#undef FUNCTION

/// Returns haze with the extinction length `distance` above a ground at `base`.
HazeModel hazeOf(float distance, float scaleHeight, float start, float base, glm::vec3 eye) {
  HazeModel model{};
  model.frame.haze = {1 / distance, scaleHeight > 0 ? 1 / scaleHeight : 0.0F, start, base};
  model.frame.horizon = {0.5F, 0.6F, 0.7F, 0};
  model.frame.zenith = {0.1F, 0.2F, 0.4F, 0};
  model.frame.nadir = {0.2F, 0.1F, 0, 0};
  model.frame.sunDirection = glm::vec4(glm::normalize(glm::vec3(1, 0.2F, -1)), 0);
  model.view.eye = glm::vec4(eye, 0);
  return model;
}

/// Returns the optical depth from a to b as a sum over many short pieces.
double summedDepth(const HazeModel& model, const glm::dvec3& a, const glm::dvec3& b, double from) {
  constexpr int pieces = 20000;
  const double way = glm::distance(a, b);
  if (way <= from) return 0;
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double t = from + (way - from) * (i + 0.5) / pieces;
    const double y = a.y + (b.y - a.y) * t / way;
    sum +=
        std::exp(-(y - static_cast<double>(model.frame.haze.w)) * static_cast<double>(model.frame.haze.y));
  }
  return sum * (way - from) / pieces * static_cast<double>(model.frame.haze.x);
}

const std::vector<glm::vec3> points = {{0, 2, -30},     {40, 0.01F, -300}, {5, 2.5F, 3},   {0, 120, 10},
                                       {-800, 60, 200}, {1, -3, -1},       {0, 900, 0.5F}, {0.1F, 1.7F, 0}};

}  // namespace

TEST_CASE("haze: the optical depth is the integral of an exponential density along the ray") {
  const glm::vec3 eye(0, 1.7F, 0.3F);
  for (const float height : {0.0F, 2.0F, 30.0F, 500.0F})
    for (const float start : {0.0F, 4.0F, 100.0F}) {
      HazeModel model = hazeOf(80, height, start, -1, eye);
      for (const glm::vec3& p : points) {
        CAPTURE(height);
        CAPTURE(start);
        CAPTURE(p.y);
        const double wanted = summedDepth(model, eye, p, static_cast<double>(start));
        CHECK(static_cast<double>(model.hazeBefore(p)) == doctest::Approx(wanted).epsilon(3e-6));
      }
    }
}

TEST_CASE("haze: level ways obey the Beer-Lambert law at every height") {
  for (const float y : {0.0F, 10.0F, 40.0F, 300.0F}) {
    HazeModel model = hazeOf(200, 25, 0, 0, {0, y, 0});
    for (const float way : {1.0F, 70.0F, 200.0F, 900.0F}) {
      const double depth = static_cast<double>(way) / 200 * std::exp(-static_cast<double>(y) / 25);
      CHECK(static_cast<double>(model.passed(model.hazeBefore({0, y, -way}))) ==
            doctest::Approx(std::exp(-depth)).epsilon(3e-6));
    }
  }
}

TEST_CASE("haze: dense haze has the sky's colour above the horizon, and the horizon's below") {
  HazeModel model = hazeOf(1, 0, 0, 0, {0, 5, 0});
  for (const glm::vec3& way : {glm::vec3(0.3F, 0.4F, -1), glm::vec3(1, 0, 0), glm::vec3(-1, -0.5F, 0.2F)}) {
    const glm::vec3 direction = glm::normalize(way);
    const glm::vec3 sky = model.skyRadiance(std::max(direction.y, 0.0F));
    const glm::vec3 p = glm::vec3(model.view.eye) + 60.0F * direction;
    CHECK(glm::distance(model.throughHaze(glm::vec3(9), 1, p), sky) < 1e-5F);
    CHECK(glm::distance(model.throughHaze(glm::vec3(0), 0.25F, p), 0.25F * sky) < 1e-5F);
  }
  model.frame.sunLight = glm::vec4(2);
  model.frame.sunGlow = 0.12F;
  const glm::vec3 towards(model.frame.sunDirection);
  CHECK(glm::distance(model.hazeTowards(towards), model.skyInDirection(towards)) < 1e-5F);
}

TEST_CASE("haze: light of the picture in a mirror is what the mirror's own ray would bring") {
  HazeModel model = hazeOf(60, 20, 0, 0, {0, 1.6F, 4});
  const glm::vec3 mirror(1, 0.8F, -20);
  const glm::vec3 direction = glm::normalize(glm::vec3(-0.3F, 0.2F, -1));
  const glm::vec3 light(0.9F, 0.3F, 0.1F);
  for (const float metres : {0.5F, 12.0F, 90.0F}) {
    const glm::vec3 end = mirror + metres * direction;
    const glm::vec4 shown(model.throughHaze(light, 1, end), 1);
    const glm::vec4 found = model.pictureThroughHaze(0.5F * shown, mirror, direction, metres);
    const float passes = model.passed(model.hazeBehind(mirror, metres * direction));
    CHECK(found.w == 0.5F);
    CHECK(glm::distance(glm::vec3(found), 0.5F * model.mirroredThroughHaze(light, passes, direction)) <
          2e-5F);
  }
}
