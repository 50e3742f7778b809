// Tests path-traced light by comparison with closed forms.
#include "base/hash.hpp"
#include "draw/exact/rays/ray_light.hpp"
#include "gpu/draw/exact/ray_stage.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <tuple>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

TEST_CASE("rays: in a furnace white things have the light of what is around them") {
  testContext();
  for (const auto& [metallic, roughness, maximum] :
       {std::tuple(0.0F, 0.9F, 0.012), {0.0F, 0.3F, 0.012}, {1.0F, 0.05F, 0.012}}) {
    CAPTURE(metallic);
    CAPTURE(roughness);
    InstanceStage ball({glm::vec3(0)});
    ball.instances.shape = sim::Instances::Shape::sphere;
    ball.instances.size = 2.0F;
    ball.material.color = glm::vec3(1);
    ball.material.roughness = roughness;
    ball.material.metallic = metallic;
    const RayPicture picture = rayPicture(furnace(256), {.instances = {ball.instances}}, {48, 48});
    const double mean = picture.mean({16, 16}, {32, 32}).x;
    CHECK(std::abs(mean - 1) < maximum);
  }
}

TEST_CASE("rays: in a furnace a surface sends what its lobe mirrors, and its albedo of the rest") {
  testContext();
  TriangleStage sheet({{-9, -9, 0}, {9, -9, 0}, {-9, 9, 0}, {9, 9, 0}}, {0, 1, 2, 2, 1, 3},
                      std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  sheet.material.color = glm::vec3(0.7F, 0.4F, 0.1F);
  sheet.material.roughness = 1;
  const RayPicture picture = rayPicture(furnace(256), {.surfaces = {sheet.surface}}, {32, 32});
  const glm::dvec3 mean = picture.mean({12, 12}, {20, 20});
  // Light reflected by a lobe of roughness 1 and F0 0.04 at normal incidence: integral of F D G2 / (4 n.v)
  // over the hemisphere, by the midpoint rule.
  double mirrored = 0;
  constexpr int steps = 2000;
  for (int i = 0; i < steps; ++i) {
    const double nl = (i + 0.5) / steps;
    const double halfCosine = std::sqrt(0.5 * (1 + nl));
    const double fresnel = 0.04 + 0.96 * std::pow(1 - halfCosine, 5);
    const double lambda = 0.5 * (std::sqrt(1 + (1 - nl * nl) / (nl * nl)) - 1);
    mirrored += fresnel / pi / (1 + lambda) / 4 * 2 * pi / steps;
  }
  for (int channel = 0; channel < 3; ++channel) {
    const double albedo = static_cast<double>(glm::vec3(0.7F, 0.4F, 0.1F)[channel]);
    const double wanted = mirrored + albedo * (1 - mirrored);
    CHECK(std::abs(mean[channel] - wanted) < 0.006);
  }
}

TEST_CASE("rays: where two triangles that shine meet, a pixel has the light of both sides") {
  testContext();
  TriangleStage sheet({{-9, -9, 0}, {9, -9, 0}, {-9, 9, 0}, {9, 9, 0}}, {0, 1, 2, 2, 1, 3},
                      std::vector<glm::vec3>(4, glm::vec3(0, 0, 1)));
  sheet.material.color = glm::vec3(0.8F);
  sheet.material.roughness = 1;
  sheet.material.finish.emission = glm::vec3(1);
  sheet.material.finish.emissionStrength = 9;
  const RayPicture picture = rayPicture(furnace(16), {.surfaces = {sheet.surface}}, {24, 24}, 4);
  const double away = picture.mean({0, 0}, {8, 8}).x;  // the seam runs from corner to corner
  CHECK(away == doctest::Approx(9.8).epsilon(0.02));
  for (int i = 0; i < 24; ++i) {
    CHECK(picture.at(i, i).x == doctest::Approx(away).epsilon(0.03));
    CHECK(picture.at(i, 23 - i).x == doctest::Approx(away).epsilon(0.03));
  }
}

TEST_CASE("rays: a ball above the ground keeps the sky's light out by its form factor") {
  testContext();
  scene::Scene scene = furnace(256);
  setGround(scene, 0.5F);
  // The camera looks from the side, past the ball.
  scene.camera.position = glm::vec3(0, 0.9F, 9);
  scene.camera.fieldOfView = 2.0F;
  InstanceStage ball({glm::vec3(0, 2, 0)});
  ball.instances.shape = sim::Instances::Shape::sphere;
  ball.instances.size = 2.0F;
  ball.material.color = glm::vec3(0);
  ball.material.roughness = 1;
  const auto light = [&](const sim::Drawables& drawables) {
    return rayPicture(scene, drawables, {16, 16}).mean({6, 7}, {10, 9}).x;
  };
  const double open = light({});
  const double shaded = light({.instances = {ball.instances}});
  // The form factor is (R/h)^2 directly below the ball (Howell, B-38). The ball reflects a few hundredths
  // of the light.
  CHECK(open > 0.4);
  CHECK(std::abs(shaded / open - 0.75) < 0.02);
}

TEST_CASE("rays: a straight edge has a penumbra as wide as the sun is") {
  testContext();
  scene::Scene scene = furnace(256);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  scene.sun.intensity = 3.0F;
  scene.sun.color = glm::vec3(1);
  scene.sun.direction = glm::vec3(0, 1, 0);
  scene.sun.diameter = 20.0F;
  setGround(scene, 0.5F);
  // The sheet is wide, at x < 0, and one metre above the ground. The camera is between sheet and ground.
  TriangleStage sheet({{-50, 1, -50}, {0, 1, -50}, {-50, 1, 50}, {0, 1, 50}}, {0, 2, 1, 1, 2, 3});
  sheet.surface.doubleSided = true;
  sheet.material.color = glm::vec3(0);
  sheet.material.roughness = 1;
  lookDown(scene, 0.8F, 20);
  const glm::ivec2 size(64, 16);
  const RayPicture picture = rayPicture(scene, {.surfaces = {sheet.surface}}, size);
  const double perMetre = 0.5 * size.y / (0.8 * std::tan(glm::radians(10.0)));
  const double radius = std::tan(glm::radians(10.0));
  const double lit = picture.mean({60, 4}, {64, 12}).x;
  CHECK(lit == doctest::Approx(0.5 * 3 / pi).epsilon(0.06));
  double worst = 0;
  for (int x = 0; x < size.x; ++x) {
    const double u = std::clamp((x + 0.5 - 0.5 * size.x) / perMetre / radius, -1.0, 1.0);
    const double share = 1 - (std::acos(u) - u * std::sqrt(1 - u * u)) / pi;
    worst = std::max(worst, std::abs(picture.mean({x, 4}, {x + 1, 12}).x / lit - share));
  }
  CHECK(worst < 0.02);
}

TEST_CASE("rays: a mirror shows a thing where its mirror image is") {
  testContext();
  scene::Scene scene = furnace(4);
  scene.camera.position = glm::vec3(0.3F, 2, 6);
  scene.camera.target = glm::vec3(0, -0.4F, 0);
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(1);
  const glm::ivec2 size(96, 64);
  const auto ballAt = [](glm::vec3 p) {
    auto ball = std::make_unique<InstanceStage>(std::vector<glm::vec3>{p});
    ball->instances.shape = sim::Instances::Shape::sphere;
    ball->instances.size = 1.2F;
    ball->material.color = glm::vec3(0);
    ball->material.roughness = 1;
    return ball;
  };
  const auto middleOf = [&](const RayPicture& picture, int firstRow) {
    glm::dvec2 sum(0);
    double count = 0;
    for (int y = firstRow; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (picture.light[4 * static_cast<std::size_t>(y * size.x + x) + 3] > 0.5F &&
            picture.at(x, y).x < 0.5) {
          sum += glm::dvec2(x, y);
          ++count;
        }
    REQUIRE(count > 50);
    return std::pair(sum / count, count);
  };
  TriangleStage mirror({{-9, 0, -9}, {9, 0, -9}, {-9, 0, 9}, {9, 0, 9}}, {0, 2, 1, 1, 2, 3});
  mirror.material.color = glm::vec3(1);
  mirror.material.metallic = 1;
  mirror.material.roughness = 0;
  const auto above = ballAt({0, 1, 0}), below = ballAt({0, -1, 0});
  const RayPicture mirrored =
      rayPicture(scene, {.surfaces = {mirror.surface}, .instances = {above->instances}}, size);
  const RayPicture real = rayPicture(scene, {.instances = {below->instances}}, size);
  const auto [wanted, pixels] = middleOf(real, 0);
  const auto [found, shown] = middleOf(mirrored, static_cast<int>(wanted.y) - 8);
  CHECK(std::abs(shown - pixels) < 0.06 * pixels);
  CHECK(glm::distance(found, wanted) < 0.5);
}

TEST_CASE("rays: bands and the order of samples in memory change nothing, to the bit") {
  testContext();
  InstanceStage balls({{0.5F, 0.4F, 0.2F}, {-0.6F, 0.3F, -0.5F}, {0.2F, 0.2F, 1.3F}});
  balls.instances.shape = sim::Instances::Shape::sphere;
  balls.instances.size = 0.6F;
  balls.material.roughness = 0.1F;
  TriangleStage sheet({{-2, 0.9F, -2}, {2, 0.7F, -2.2F}, {-2, -0.2F, 0}, {2, -0.1F, 0.2F}},
                      {0, 2, 1, 1, 2, 3});
  sheet.surface.doubleSided = true;
  sheet.material.translucency = 0.3F;
  scene::Scene scene = furnace(3);
  scene.sun.intensity = 3.0F;
  scene.sun.diameter = 6.0F;
  setGround(scene, 0.4F);
  scene::Light& lamp = scene.lights.emplace_back();
  lamp.position = glm::vec3(1, 2, 1);
  lamp.radius = 0.3F;
  scene.camera.position = glm::vec3(0.4F, 1.7F, 4.1F);
  const sim::Drawables drawables{.surfaces = {sheet.surface}, .instances = {balls.instances}};
  const RayPicture first = rayPicture(scene, drawables, {75, 41}, 4);
  for (const char* layout : LayoutForced::words()) {
    const LayoutForced asked(layout);
    CHECK(rayPicture(scene, drawables, {75, 41}, 4).light == first.light);
  }
  CHECK(hashHex(std::as_bytes(std::span(first.light))) == "2c55b75f27aa1950a6dafd538a81ce43");
}
