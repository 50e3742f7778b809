// Tests instances drawn by the exact rasterizer. Compares balls with the CPU version and with double
// precision, and mesh copies with a surface that has the same triangles.
#include "base/file.hpp"
#include "draw/exact/instances/ball_raster.hpp"
#include "draw/exact/instances/copy_raster.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/exact/instance_stage.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <limits>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using Shape = sim::Instances::Shape;

namespace {

namespace twin {

using namespace simreel::shader;
#define FUNCTION inline
#define precise
#include "glsl/draw/exact/instances/ball.glsl"
#include "glsl/draw/exact/instances/disc.glsl"
#include "glsl/draw/exact/instances/rays.glsl"
#undef precise
#undef FUNCTION

}  // namespace twin

constexpr unsigned noId = 0xffffffffU;

/// Groups of balls of several sizes, some of them around and behind the eye. Many intersect.
struct Balls {
  explicit Balls(std::uint32_t seed) {
    Dice dice(seed);
    for (const float size : {0.013F, 0.11F, 0.47F, 1.9F, 8.3F}) {
      std::vector<glm::vec3> places;
      const int count = size > 1 ? 3 : 60;
      for (int i = 0; i < count; ++i) places.push_back(3.0F * dice.cube() + glm::vec3(0, 0, 1));
      if (size > 5) places = {{9, 2, -3}, {-5, -5, 1}, {0.5F, 0.2F, 9.5F}};
      places.push_back(places.front());  // This ball is at the same position as the first one, so that
                                         // depths are equal.
      groups.emplace_back(places);
      groups.back().instances.size = size;
      groups.back().instances.shape = Shape::sphere;
      firstIds.push_back(count_ + 5);
      count_ += static_cast<unsigned>(places.size());
      for (const glm::vec3& p : places) all.push_back({p, 0.5F * size, count_});
      for (std::size_t k = 0; k < places.size(); ++k)
        all[all.size() - places.size() + k].id = firstIds.back() + static_cast<unsigned>(k);
    }
    for (InstanceStage& group : groups) drawn.push_back(&group.instances);
  }

  struct One {
    glm::vec3 middle;
    float radius;
    unsigned id;
  };
  std::deque<InstanceStage> groups;
  std::vector<const sim::Instances*> drawn;
  std::vector<unsigned> firstIds;
  std::vector<One> all;

 private:
  unsigned count_ = 0;
};

struct Drawn {
  std::vector<unsigned> keys, ids;
};

Drawn drawBalls(ExactStage& stage, const Balls& balls, int smallPixels = 16, int mediumPixels = 0) {
  draw::BallRaster raster(draw::BallRaster::Into::picture, stage.samples, smallPixels, mediumPixels);
  stage.clear();
  raster.drawNearest(balls.drawn, balls.firstIds, stage.target);
  raster.drawIds(stage.target);
  testContext().check();
  return {stage.keys(), stage.ids()};
}

}  // namespace

TEST_CASE("balls by ray: the same bits as on the CPU, which looks at every ball for every sample") {
  testContext();
  for (const int samples : {1, 4}) {
    CAPTURE(samples);
    ExactStage stage(sideScene(), {67, 45}, samples);
    const Balls balls(7);
    const Drawn found = drawBalls(stage, balls);
    const shader::ExactView& v = stage.view;
    const twin::Rays rays{glm::vec3(v.ray), glm::vec3(v.rayAcross), glm::vec3(v.rayDown)};
    int covered = 0;
    int different = 0;
    for (std::size_t i = 0; i < found.keys.size(); ++i) {
      unsigned key = noId;
      unsigned id = noId;
      for (const Balls::One& one : balls.all) {
        const twin::Ball ball = [&] {
          twin::Ball made = twin::ballAt(one.middle, one.radius, glm::vec3(v.eye), glm::vec3(v.forward));
          return made;
        }();
        const twin::BallHit hit = twin::ballHit(ball, twin::rayAt(rays, stage.place(i)));
        const float near = v.near * shader::exactReciprocal(std::max(hit.depth, 1e-6F));
        if (!hit.found || hit.depth < v.near || near < v.nearOverFar) continue;
        const unsigned here = 0x7fffffffU - static_cast<unsigned>(shader::floatBitsToInt(near));
        if (here < key) id = noId;
        key = std::min(key, here);
        if (here == key) id = std::min(id, one.id);
      }
      covered += key != noId ? 1 : 0;
      different += key != found.keys[i] || id != found.ids[i] ? 1 : 0;
    }
    CHECK(different == 0);
    CHECK(covered > 900 * samples);
    CHECK(covered < 67 * 45 * samples);
  }
}

TEST_CASE("balls by ray: coverage, depth and order as in double precision") {
  testContext();
  ExactStage stage(sideScene(), {67, 45}, 4);
  const Balls balls(11);
  const Drawn found = drawBalls(stage, balls);
  const shader::ExactView& v = stage.view;
  int close = 0;
  int wrong = 0;
  std::vector<int> shown(balls.all.size() + 5);
  for (std::size_t i = 0; i < found.keys.size(); ++i) {
    const glm::dvec2 place(stage.place(i));
    const glm::dvec3 ray = glm::dvec3(glm::vec3(v.ray)) + glm::dvec3(glm::vec3(v.rayAcross)) * place.x +
                           glm::dvec3(glm::vec3(v.rayDown)) * place.y;
    double nearest = std::numeric_limits<double>::max();
    double second = nearest;
    unsigned id = noId;
    bool doubtful = false;
    for (const Balls::One& one : balls.all) {
      // Solves |eye + t ray - middle| = radius for t.
      const glm::dvec3 from = glm::dvec3(glm::vec3(v.eye)) - glm::dvec3(one.middle);
      const double rr = glm::dot(ray, ray);
      const double b = glm::dot(from, ray);
      const double c = glm::dot(from, from) - static_cast<double>(one.radius) * one.radius;
      const double beyond = b * b - rr * c;
      doubtful = doubtful || std::abs(beyond) < 1e-3 * rr * one.radius * one.radius;
      if (beyond < 0) continue;
      const double t = -(b + std::sqrt(beyond)) / rr;
      doubtful = doubtful || std::abs(t - v.near) < 1e-4 || std::abs(t - v.near / v.nearOverFar) < 1e-3;
      if (t < v.near || t > v.near / v.nearOverFar) continue;
      if (t < nearest) {
        if (t < nearest - 1e-4) second = nearest;
        nearest = t;
        id = one.id;
      } else if (t > nearest) {
        second = std::min(second, t);
      }
    }
    if (doubtful || (id != noId && second - nearest < 1e-4)) {
      ++close;
      continue;
    }
    wrong += found.ids[i] != id ? 1 : 0;
    if (id == noId) continue;
    ++shown[id];
    const auto near =
        static_cast<double>(shader::intBitsToFloat(static_cast<int>(0x7fffffffU - found.keys[i])));
    wrong += std::abs(v.near / near - nearest) > 2e-5 * nearest ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(close < 500);
  CHECK(std::count_if(shown.begin(), shown.end(), [](int count) { return count > 3; }) > 30);
}

TEST_CASE("balls, large or small: forcing either way of drawing changes nothing") {
  testContext();
  for (const int samples : {1, 2, 8, 16}) {
    ExactStage stage(sideScene(), {67, 45}, samples);
    const Balls balls(5);
    const Drawn usual = drawBalls(stage, balls);
    for (const auto& [smallPixels, mediumPixels] : {std::pair(0, 0), {3, 0}, {64, 0}, {0, 64}, {2, 9}}) {
      CAPTURE(smallPixels);
      CAPTURE(mediumPixels);
      const Drawn other = drawBalls(stage, balls, smallPixels, mediumPixels);
      CHECK(other.keys == usual.keys);
      CHECK(other.ids == usual.ids);
    }
  }
}

TEST_CASE("of balls in one place the one with the least number is shown, and dead ones never are") {
  testContext();
  ExactStage stage(darkScene(), {33, 31}, 4);
  const glm::vec4 place(0, 0, 0, 1);
  const glm::vec4 lost(1e30F, 0, 0, 1);
  InstanceStage group({place, lost, place, place, place},
                      {{0, 0, 0, -1}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0, 0.5F}});
  group.instances.size = 2;
  InstanceStage second(std::vector<glm::vec3>(1, glm::vec3(0)));
  second.instances.size = 2;
  draw::BallRaster raster(draw::BallRaster::Into::picture, 4);
  raster.drawNearest({&second.instances, &group.instances}, {900, 100}, stage.target);
  raster.drawIds(stage.target);
  const std::vector<unsigned> ids = stage.ids();
  CHECK(std::count(ids.begin(), ids.end(), 102U) > 500);
  CHECK(std::count(ids.begin(), ids.end(), 102U) + std::count(ids.begin(), ids.end(), noId) ==
        static_cast<int>(ids.size()));
}

TEST_CASE("small balls cover a disk of 0.57 pixels of radius in the mean") {
  testContext();
  ExactStage stage(darkScene(), {131, 99}, 4);
  Dice dice(31);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 400; ++i) places.push_back(1.5F * dice.cube());
  InstanceStage group(places);
  group.instances.size = 1e-4F;
  draw::BallRaster raster(draw::BallRaster::Into::picture, 4);
  raster.drawNearest({&group.instances}, {0}, stage.target);
  raster.drawIds(stage.target);
  const std::vector<unsigned> ids = stage.ids();
  const auto shown =
      static_cast<double>(ids.size()) - static_cast<double>(std::count(ids.begin(), ids.end(), noId));
  CHECK(shown / 400 == doctest::Approx(4 * 3.14159265 * 0.57 * 0.57).epsilon(0.07));
}

TEST_CASE("copies of a mesh cover what the same triangles of a surface cover, with the same numbers") {
  testContext();
  const DartStage mesh;
  Dice dice(3);
  for (const float size : {0.5F, 2.7F}) {
    CAPTURE(size);
    std::vector<glm::vec3> places;
    for (int i = 0; i < 77; ++i) places.push_back(3.0F * dice.cube() + glm::vec3(0, 0, 1.5F));
    places.push_back(places[40]);
    InstanceStage group(places);
    group.instances.size = size;
    group.instances.shape = Shape::mesh;
    for (const int samples : {1, 4}) {
      ExactStage stage(sideScene(), {67, 45}, samples);
      const DartSurface same(mesh, places, size);
      draw::TriangleRaster surfaces(draw::TriangleRaster::Into::picture, samples);
      surfaces.number({&same.surface});
      surfaces.draw(stage.target);
      const Drawn wanted{stage.keys(), stage.ids()};
      CHECK(std::count(wanted.ids.begin(), wanted.ids.end(), noId) < (67 * 45 - 60) * samples);
      for (const auto& [smallPixels, pairs] : {std::pair(16, 1U << 22U), {0, 100U}, {64, 17U}}) {
        CAPTURE(smallPixels);
        draw::CopyRaster raster(draw::CopyRaster::Into::picture, samples, smallPixels, pairs,
                                pairs == 17U ? 0 : 40);
        stage.clear();
        raster.drawNearest({{&group.instances, &mesh.shape}}, {0}, stage.target);
        raster.drawIds(stage.target);
        testContext().check();
        CHECK(stage.keys() == wanted.keys);
        CHECK(stage.ids() == wanted.ids);
      }
    }
  }
}

TEST_CASE("instances of every kind look alike in both rasterizers") {
  testContext();
  scene::Scene scene;
  scene.camera.position = glm::vec3(0.3F, 1.6F, 4);
  scene.camera.target = glm::vec3(0, 0.5F, 0);
  scene.ground.emplace();
  scene.ground->height = 0;
  const auto file = temporaryFile("exact_dart.obj");
  writeFileAtomically(file,
                      "v 0 0 0.6\nv 0.34 0.03 -0.4\nv -0.34 0.03 -0.4\nv 0 -0.14 -0.4\n"
                      "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  Dice dice(23);
  std::vector<glm::vec4> places;
  std::vector<glm::vec4> speeds;
  for (int i = 0; i < 60; ++i) {
    places.emplace_back(dice.cube() + glm::vec3(0, 1.2F, 0), 1 + dice());
    speeds.emplace_back(dice.cube(), dice());
  }
  const std::vector<glm::vec3> colors = {{0.9F, 0.1F, 0.1F}, {0.1F, 0.9F, 0.2F}, {0.2F, 0.3F, 1}};
  for (const Shape shape : {Shape::sprite, Shape::sphere, Shape::mesh})
    for (const bool additive : {false, true}) {
      CAPTURE(static_cast<int>(shape));
      CAPTURE(additive);
      InstanceStage group(places, speeds);
      group.instances.shape = shape;
      group.instances.mesh = file;
      group.instances.additive = additive;
      group.instances.turning = sim::Instances::Turning::velocity;
      group.instances.size = 0.3F;
      group.instances.massExponent = 1.0F / 3;
      group.instances.colorBy = sim::Instances::ColorBy::speed;
      group.instances.colorRange = {0, 1.5F};
      group.instances.colors = &colors;
      group.instances.brightness = 0.4F;
      group.material.roughness = 0.2F;
      group.material.metallic = 0.5F;
      scene.render.rasterizer = scene::Rasterizer::driver;
      const Picture wanted = drawn(scene, {{}, {group.instances}}, {161, 121});
      const Picture empty = drawn(scene, {}, {161, 121});
      scene.render.rasterizer = scene::Rasterizer::exact;
      const Picture found = drawn(scene, {{}, {group.instances}}, {161, 121});
      CHECK(compare(wanted, empty).far > 500);
      // The driver's sprites have the depth of a flat square, so pictures differ where balls intersect. The
      // driver's spheres have facets.
      CHECK(compare(found, wanted).mean < (shape == Shape::mesh     ? 0.7
                                           : shape == Shape::sphere ? 2.2
                                                                    : 1.2));
      CHECK(compare(found, wanted).far < compare(wanted, empty).far / 8);
    }
}
