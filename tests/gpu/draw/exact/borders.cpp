// Tests primitives that lie exactly on a limit: pixel borders, near and far plane, borders of glows, and
// the clipping region.
#include "draw/exact/instances/ball_raster.hpp"
#include "draw/exact/instances/glow_raster.hpp"
#include "gpu/draw/exact/instance_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "reference/raster_twin.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

namespace border {

using namespace simreel::shader;
#define FUNCTION inline
#define precise
#include "glsl/draw/exact/instances/ball.glsl"
#include "glsl/draw/exact/instances/rays.glsl"
#undef precise
#undef FUNCTION

}  // namespace border

constexpr unsigned noNumber = 0xffffffffU;

/// Returns the light (RGBA) of one glow on a black background.
std::vector<glm::vec4> lightOfGlow(ExactStage& stage, const sim::Instances& glow) {
  gl::Texture light = gl::Texture::image("light", GL_RGBA32F, stage.size.x, stage.size.y);
  constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
  glClearTexImage(light.name(), 0, GL_RGBA, GL_FLOAT, none.data());
  stage.clear();
  draw::GlowRaster raster(stage.samples);
  raster.prepare(stage.size);
  raster.draw({&glow}, stage.target);
  raster.addTo(stage.size, light);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  std::vector<glm::vec4> found(static_cast<std::size_t>(stage.size.x * stage.size.y));
  glGetTextureImage(light.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(found.size() * 16),
                    found.data());
  testContext().check();
  return found;
}

}  // namespace

TEST_CASE("exact borders: edges within a few 1/256 of pixels' borders, where sixteen samples have one") {
  testContext();
  const glm::ivec2 size(101, 67);
  const auto view = exactViewFrom({0, 0, 5}, {0, 0, 0}, size);
  // Number of pixels per metre at z = 0.
  const double metre = size.y / (2 * 5 * std::tan(20 * 3.14159265358979 / 180));
  const auto at = [&](double x, double y) {
    return glm::vec3((x - 0.5 * size.x) / metre, (0.5 * size.y - y) / metre, 0);
  };
  std::vector<glm::vec3> places;
  std::vector<unsigned> corners;
  int k = 0;
  for (int y = 3; y < 60; y += 6)
    for (int x = 3; x < 95; x += 5, ++k) {
      const double aside = (k % 9 - 4) / 256.0;
      const double lean = k / 9 % 3 == 0 ? 0 : (k % 2 == 0 ? 1 : -1) / 256.0;
      // The nearly vertical edge is the right edge of the triangle if k % 4 < 2, otherwise its left edge.
      places.push_back(at(x + aside, y + 0.01));
      places.push_back(at(x + aside + lean, y + 4.7));
      places.push_back(at(k % 4 < 2 ? x - 2.3 : x + 2.3, y + 2.1));
      for (int i = 0; i < 3; ++i) corners.push_back(static_cast<unsigned>(corners.size()));
    }
  TriangleStage stage(places, corners);
  stage.surface.doubleSided = true;
  for (const int samples : {1, 4, 8, 16}) {
    CAPTURE(samples);
    const auto twin = rasterTwin(view, samples, true, places, corners);
    for (const auto& [smallPixels, binRoom] : {std::pair(64, 0), {0, 0}, {64, 1 << 20}}) {
      CAPTURE(smallPixels);
      CAPTURE(binRoom);
      const SeenSamples seen = seenBy(view, samples, {&stage.surface}, smallPixels, 1000, 0, binRoom);
      CHECK(seen.ids == twin.ids);
      CHECK(seen.keys == twin.keys);
    }
  }
}

TEST_CASE("exact borders: what was clipped before leaves nothing where all is clipped away") {
  testContext();
  const auto view = exactViewFrom({0, 0, 5}, {0, 0, 0}, {67, 45});
  std::vector<glm::vec3> around;
  std::vector<glm::vec3> beyond;
  std::vector<unsigned> corners;
  for (unsigned i = 0; i < 30; ++i) corners.push_back(i);
  for (int i = 0; i < 10; ++i) {
    const float z = -0.1F * static_cast<float>(i);
    around.insert(around.end(), {{-900, -900, z}, {900, -900, z}, {0, 1300, z}});
    // The corners of the triangle are beyond a corner of the guard band around the picture, but the
    // triangle is not completely beyond any side of the picture.
    beyond.insert(beyond.end(), {{0, 3000, z}, {3000, 0, z}, {3000, 3000, z}});
  }
  TriangleStage before(around, corners);
  TriangleStage after(beyond, corners);
  before.surface.doubleSided = after.surface.doubleSided = true;
  gl::Buffer block("view", sizeof view);
  block.write(0, std::as_bytes(std::span(&view, 1)));
  block.bindUniform(draw::viewBinding, 0, sizeof view);
  const draw::Visibility visibility("a test", view.size, 4, true);
  for (const int binRoom : {draw::binnedTriangles(), 0}) {
    draw::TriangleRaster raster(draw::TriangleRaster::Into::picture, 4, 16, 1000, draw::mediumTriangle(),
                                binRoom);
    const auto hidden = [&](TriangleStage& stage) {
      visibility.clear();
      raster.number({&stage.surface});
      raster.draw(visibility);
      const std::vector<GLuint> ids = visibility.readNumbers();
      return std::count(ids.begin(), ids.end(), noNumber);
    };
    CHECK(hidden(before) == 0);
    CHECK(hidden(after) == std::ptrdiff_t{4} * 67 * 45);
  }
}

TEST_CASE("exact borders: a ball's place at the nearest plane or the farthest itself is shown") {
  testContext();
  ExactStage stage(sideScene(), {9, 7}, 1);
  const shader::ExactView& v = stage.view;
  const border::Rays rays{glm::vec3(v.ray), glm::vec3(v.rayAcross), glm::vec3(v.rayDown)};
  const glm::vec2 middle(4.5F, 3.5F);
  const glm::vec3 ray = border::rayAt(rays, middle);
  for (const bool far : {false, true}) {
    CAPTURE(far);
    // Steps through radii around the one at which the ball touches the depth limit. Tests a few radii for
    // which the ball's depth equals the limit exactly, and every hundredth of the other radii.
    const float depth = far ? 9 : 0.3F;
    int equal = 0;
    int wrong = 0;
    std::array<int, 2> sides{};
    // Uses several distances, because at one of them rounding may skip the exact depth.
    for (const float beyond : {0.8F, 0.7F, 0.9F}) {
      const float distance = depth + beyond;
      const glm::vec3 place = glm::vec3(v.eye) + distance * ray;
      float size = 2 * (distance - depth) * glm::length(ray);
      for (int i = 0; i < 400; ++i) size = std::nextafter(size, 0.0F);
      for (int i = 0; i < 800; ++i, size = std::nextafter(size, 9.0F)) {
        const border::Ball ball =
            border::ballAt(place, size * 0.5F, glm::vec3(v.eye), glm::vec3(v.forward));
        const float hit = border::ballHit(ball, ray).depth;
        const float near = v.near * shader::exactReciprocal(hit);
        const bool same = far ? near == v.nearOverFar : hit == v.near;
        const bool within = hit >= v.near && near >= v.nearOverFar;
        ++sides[within ? 1 : 0];
        if (!same && i % 100 != 0) continue;
        if (same && ++equal > 3) continue;
        InstanceStage group({glm::vec4(place, 1)}, {glm::vec4(0)});
        group.instances.size = size;
        group.instances.shape = sim::Instances::Shape::sphere;
        draw::BallRaster raster(draw::BallRaster::Into::picture, 1);
        stage.clear();
        raster.drawNearest({&group.instances}, {0}, stage.target);
        raster.drawIds(stage.target);
        wrong += (stage.ids()[3 * 9 + 4] != noNumber) != within ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
    CHECK(equal > 0);
    CHECK(sides[0] > 50);
    CHECK(sides[1] > 50);
  }
}

TEST_CASE("exact borders: a bright glow in space close to the eye, and nothing beyond its rim") {
  testContext();
  scene::Scene scene = sideScene();
  scene.camera.near = 0.02F;
  scene.camera.fieldOfView = 60;
  ExactStage stage(scene, {131, 77}, 4);
  const shader::ExactView& v = stage.view;
  const glm::vec3 middle = glm::vec3(v.eye) + 0.31F * glm::vec3(v.forward);
  const double radius = 0.1;
  scene::Material material;
  material.color = glm::vec3(40, 1, 1);
  InstanceStage glow({glm::vec4(middle, 1)}, {{0, 0, 0, 0.5F}});
  glow.instances.size = static_cast<float>(2 * radius);
  glow.instances.additive = true;
  glow.instances.discs = true;
  glow.instances.material = &material;
  const auto found = lightOfGlow(stage, glow.instances);
  const glm::dvec3 from = glm::dvec3(middle) - glm::dvec3(glm::vec3(v.eye));
  double worst = 0;
  int rim = 0;
  int lit = 0;
  for (int y = 0; y < stage.size.y; ++y)
    for (int x = 0; x < stage.size.x; ++x) {
      const glm::dvec3 ray = glm::dvec3(glm::vec3(v.ray)) + glm::dvec3(glm::vec3(v.rayAcross)) * (x + 0.5) +
                             glm::dvec3(glm::vec3(v.rayDown)) * (y + 0.5);
      const glm::dvec3 off = ray * (glm::dot(from, from) / glm::dot(from, ray)) - from;
      const double square = glm::dot(off, off) / (radius * radius);
      const float light = found[static_cast<std::size_t>(y * stage.size.x + x)].r;
      const double part = std::max(1 - square, 0.0);
      worst = std::max(worst, std::abs(static_cast<double>(light) - 40 * part * part));
      lit += part > 0 ? 1 : 0;
      if (square < 1.0001 || square > 1.0099) continue;
      ++rim;
      CHECK(light == 0.0F);
    }
  CHECK(worst < 1e-3);
  CHECK(lit > 500);
  CHECK(rim > 4);
}

TEST_CASE("exact borders: a glow over more pixels than an invocation may go through") {
  testContext();
  InstanceStage glow({{0, 0, 0, 1}}, {{0, 0, 0, 0.5F}});
  glow.instances.size = 4000;
  glow.instances.additive = true;
  glow.instances.discs = true;
  for (const glm::ivec2 size : {glm::ivec2(401, 301), glm::ivec2(11, 6100)}) {
    CAPTURE(size.x);
    ExactStage stage(darkScene(), size, 1);
    const auto found = lightOfGlow(stage, glow.instances);
    const float all = glow.material.color.r;
    CHECK(std::all_of(found.begin(), found.end(),
                      [&](glm::vec4 light) { return std::abs(light.r - all) < 1e-3F * all; }));
  }
}
