// Tests glows drawn by the exact rasterizer by comparison with their formula in double precision.
#include "draw/exact/instances/ball_raster.hpp"
#include "draw/exact/instances/glow_raster.hpp"
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/exact/instance_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Computes the light of a glow at a pixel's centre in double precision. The light is (1 - (distance /
/// radius)^2)^2 on a disc that faces the eye or, if `round` is true, on a circle in the picture plane.
class GlowFormula {
 public:
  explicit GlowFormula(const shader::ExactView& v)
      : eye_(v.eye),
        forward_(v.forward),
        across_(v.across),
        down_(v.down),
        ray_(v.ray),
        rayAcross_(v.rayAcross),
        rayDown_(v.rayDown) {}
  /// Returns the number of pixels per metre at depth 1.
  [[nodiscard]] double perMetre() const {
    return glm::length(across_ - forward_ * glm::dot(across_, forward_));
  }
  [[nodiscard]] double inside(glm::dvec3 middle, double radius, glm::dvec2 place, bool round) const {
    const glm::dvec3 from = middle - eye_;
    const double depth = glm::dot(from, forward_);
    const double pixels = radius * perMetre() / depth;
    double square = 0;
    if (round) {
      const glm::dvec2 at(glm::dot(from, across_) / depth, glm::dot(from, down_) / depth);
      square = glm::dot(place - at, place - at) / (pixels * pixels);
    } else {
      const glm::dvec3 ray = ray_ + rayAcross_ * place.x + rayDown_ * place.y;
      const glm::dvec3 off = ray * (glm::dot(from, from) / glm::dot(from, ray)) - from;
      square = glm::dot(off, off) / (radius * radius);
    }
    const double part = std::max(1 - square, 0.0);
    return part * part;
  }

 private:
  glm::dvec3 eye_, forward_, across_, down_, ray_, rayAcross_, rayDown_;
};

/// Returns the light (RGBA) of glows on a black background.
std::vector<glm::vec4> lightOf(ExactStage& stage, draw::GlowRaster& raster, const sim::Instances& glows) {
  gl::Texture light = gl::Texture::image("light", GL_RGBA32F, stage.size.x, stage.size.y);
  constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
  glClearTexImage(light.name(), 0, GL_RGBA, GL_FLOAT, none.data());
  raster.prepare(stage.size);
  raster.draw({&glows}, stage.target);
  raster.addTo(stage.size, light);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> found(static_cast<std::size_t>(stage.size.x * stage.size.y));
  glGetTextureImage(light.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(found.size() * 16),
                    found.data());
  testContext().check();
  return found;
}

}  // namespace

TEST_CASE("glows: the sum of their formula in double precision, in any order and drawn in any way") {
  testContext();
  bool discs = false;
  SUBCASE("round on the picture") {}
  SUBCASE("discs in space") {
    discs = true;
  }
  scene::Scene scene = sideScene();
  scene.camera.fieldOfView = 40;
  ExactStage stage(scene, {67, 45}, 4);
  Dice dice(19);
  std::vector<glm::vec4> places;
  std::vector<glm::vec4> speeds;
  for (int i = 0; i < 900; ++i) {
    places.emplace_back(2.0F * dice.cube() - glm::vec3(0, 0, 1), 1);
    speeds.emplace_back(dice.cube(), 0.5F);
  }
  scene::Material material;
  material.color = glm::vec3(1, 0.5F, 300.0F);  // the sums of the blue light do not fit into their lower
                                                // words
  const auto run = [&](int smallPixels, int mediumPixels = 0) {
    InstanceStage group(places, speeds);
    group.instances.size = 0.7F;
    group.instances.additive = true;
    group.instances.discs = discs;
    group.instances.brightness = 0.37F;
    group.instances.material = &material;
    draw::GlowRaster raster(4, smallPixels, mediumPixels);
    const auto first = lightOf(stage, raster, group.instances);
    CHECK(lightOf(stage, raster, group.instances) == first);  // the results are equal, because addTo() has
                                                              // cleared the sums
    return first;
  };
  const auto found = run(12);
  CHECK(run(0) == found);
  CHECK(run(64) == found);
  CHECK(run(0, 64) == found);
  CHECK(run(3, 11) == found);
  std::reverse(places.begin(), places.end());
  std::reverse(speeds.begin(), speeds.end());
  CHECK(run(12) == found);

  double worst = 0;
  double maximum = 0;
  const GlowFormula formula(stage.view);
  for (int y = 0; y < stage.size.y; ++y)
    for (int x = 0; x < stage.size.x; ++x) {
      double sum = 0;
      for (const glm::vec4& place : places)
        sum += 0.37 * formula.inside(glm::vec3(place), 0.35, {x + 0.5, y + 0.5}, !discs);
      const glm::vec4 light = found[static_cast<std::size_t>(y * stage.size.x + x)];
      worst = std::max({worst, std::abs(light.r - sum), std::abs(light.g - 0.5 * sum),
                        std::abs(light.b - 300 * sum) / 300});
      maximum = std::max(maximum, sum);
      CHECK(light.a == 0.0F);
    }
  CHECK(maximum > 3);
  CHECK(worst < 2e-4);
}

TEST_CASE("a glow whose middle lies beyond an edge of the picture shows what of it reaches in") {
  testContext();
  scene::Scene scene = sideScene();
  scene.camera.fieldOfView = 60;
  ExactStage stage(scene, {131, 77}, 4);
  const shader::ExactView& v = stage.view;
  const GlowFormula formula(v);
  const glm::vec2 size(stage.size);
  for (const glm::vec2 place : {glm::vec2(-9, 40), glm::vec2(size.x + 9, 31), glm::vec2(60, -9),
                                glm::vec2(70, size.y + 9), glm::vec2(-4, -4)}) {
    CAPTURE(place.x);
    CAPTURE(place.y);
    const glm::vec3 ray =
        glm::vec3(v.ray) + glm::vec3(v.rayAcross) * place.x + glm::vec3(v.rayDown) * place.y;
    const glm::vec3 middle = glm::vec3(v.eye) + 1.7F * ray;
    // The glows are discs in space, like the glows of lamps. They appear larger away from the picture's
    // centre. With a radius of 8.7 pixels, a circle in the picture plane would not extend into the picture,
    // but the disc does.
    for (const float pixels : {8.7F, 11.0F, 40.0F}) {
      CAPTURE(pixels);
      const auto radius = static_cast<float>(pixels * 1.7 / formula.perMetre());
      InstanceStage glow({glm::vec4(middle, 1)}, {{0, 0, 0, 0.5F}});
      glow.instances.size = 2 * radius;
      glow.instances.additive = true;
      glow.instances.discs = true;
      draw::GlowRaster raster(4);
      const auto found = lightOf(stage, raster, glow.instances);
      double worst = 0;
      double sum = 0;
      for (int y = 0; y < stage.size.y; ++y)
        for (int x = 0; x < stage.size.x; ++x) {
          const double wanted =
              glow.material.color.r * formula.inside(middle, radius, {x + 0.5, y + 0.5}, false);
          const glm::vec4 light = found[static_cast<std::size_t>(y * stage.size.x + x)];
          worst = std::max(worst, std::abs(light.r - wanted));
          sum += wanted;
        }
      CHECK(worst < 1e-4);
      CHECK(sum > 0.01);
    }
  }
}

TEST_CASE("a glow smaller than a pixel has the light of its area at any place, and a round footprint") {
  testContext();
  scene::Scene scene = darkScene();
  ExactStage stage(scene, {41, 37}, 4);
  const shader::ExactView& v = stage.view;
  const GlowFormula formula(v);
  const double depth = 3;
  const double pixels = 0.5;
  for (int step = 0; step < 16; ++step) {
    CAPTURE(step);
    const glm::vec2 steps(step % 4, step / 4);
    const glm::vec2 place = glm::vec2(20, 18) + 0.25F * steps;
    const glm::vec3 ray =
        glm::vec3(v.ray) + glm::vec3(v.rayAcross) * place.x + glm::vec3(v.rayDown) * place.y;
    InstanceStage glow({glm::vec4(glm::vec3(v.eye) + static_cast<float>(depth) * ray, 1)},
                       {{0, 0, 0, 0.5F}});
    glow.instances.size = static_cast<float>(2 * pixels * depth / formula.perMetre());
    glow.instances.additive = true;
    draw::GlowRaster raster(4);
    const auto found = lightOf(stage, raster, glow.instances);
    double sum = 0;
    for (const glm::vec4& light : found) sum += static_cast<double>(light.r);
    // The integral of (1 - (distance / radius)^2)^2 over a disc is a third of the disc's area.
    const double whole =
        std::numbers::pi / 3 * pixels * pixels * static_cast<double>(glow.material.color.r);
    CHECK(sum == doctest::Approx(whole).epsilon(0.05));
    if (step > 0) continue;
    const auto at = [&](int x, int y) { return found[static_cast<std::size_t>(y * 41 + x)].r; };
    CHECK(at(19, 17) > 0.0F);  // the four pixels around the glow, then their neighbours and the corners
    CHECK(at(18, 17) > 0.02F * at(19, 17));
    CHECK(at(18, 16) == 0.0F);
  }
}

TEST_CASE("glows show before what is nearer to the eye only, sample by sample") {
  testContext();
  ExactStage stage(darkScene(), {41, 37}, 4);
  InstanceStage wall(std::vector<glm::vec3>(1, glm::vec3(0, 0, -20)));
  wall.instances.size = 40;  // the front of the ball is at z = 0 and is nearly flat
  draw::BallRaster balls(draw::BallRaster::Into::picture, 4);
  scene::Material material;
  for (const float z : {0.5F, -0.5F}) {
    InstanceStage glow({{0, 0, z, 1}}, {{0, 0, 0, 0.5F}});
    glow.instances.size = 1;
    glow.instances.additive = true;
    glow.instances.material = &material;
    stage.clear();
    balls.drawNearest({&wall.instances}, {}, stage.target);
    draw::GlowRaster raster(4);
    const auto found = lightOf(stage, raster, glow.instances);
    const float sum = found[18 * 41 + 20].r;
    CHECK((sum > 0) == (z > 0));
  }
}
