// Tests that pictures do not depend on the grouping of objects. In one list or several lists, and in any
// order, the bytes must be the same, including shadows and lamp light.
#include "base/file.hpp"
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"
#include "gpu/draw/lamp_stage.hpp"

#include <algorithm>
#include <deque>
#include <span>

#include <doctest/doctest.h>

using namespace simreel;
using Shape = sim::Instances::Shape;

namespace {

constexpr glm::ivec2 pictureSize(91, 67);

/// Returns a scene with ground, sun and a lamp, both with shadows, seen from the side.
scene::Scene dealtScene() {
  scene::Scene scene;
  scene.render.rasterizer = scene::Rasterizer::exact;
  scene.camera.position = glm::vec3(0.3F, 2.1F, 4);
  scene.camera.target = glm::vec3(0.1F, 0.6F, 0);
  scene.sun.shadow = true;
  scene.ground.emplace();
  scene.ground->height = 0;
  scene.lights.push_back(lampAt(glm::vec3(-1.3F, 2.2F, 1.1F), 40, true));
  return scene;
}

struct Things {
  std::vector<glm::vec4> places, speeds;
};

/// Returns objects of many sizes, from far below a pixel to a third of the picture, all at different
/// positions.
Things someThings(int count) {
  Dice dice(41);
  Things all;
  for (int i = 0; i < count; ++i) {
    const float mass = i % 11 == 0 ? 40.0F : i % 3 == 0 ? 0.0003F : 0.3F + dice();
    all.places.emplace_back(1.7F * dice.cube() + glm::vec3(0, 1.5F, 0), mass);
    all.speeds.emplace_back(dice.cube(), dice());
  }
  return all;
}

/// Returns the objects in consecutive groups. `ends`: index after the last object of each group.
std::deque<InstanceStage> grouped(const Things& all, const std::vector<std::size_t>& ends) {
  std::deque<InstanceStage> groups;
  std::size_t from = 0;
  for (const std::size_t end : ends) {
    const auto part = [&](const std::vector<glm::vec4>& of) {
      return std::vector(of.begin() + static_cast<std::ptrdiff_t>(from),
                         of.begin() + static_cast<std::ptrdiff_t>(end));
    };
    groups.emplace_back(part(all.places), part(all.speeds));
    from = end;
  }
  return groups;
}

}  // namespace

TEST_CASE("exact parts: instances in one group, in several or in the other order have the same bytes") {
  testContext();
  const auto file = temporaryFile("exact_parts.obj");
  writeFileAtomically(file,
                      "v 0 0 0.6\nv 0.34 0.03 -0.4\nv -0.34 0.03 -0.4\nv 0 -0.14 -0.4\n"
                      "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::vector<glm::vec3> colors = {{0.9F, 0.1F, 0.1F}, {0.1F, 0.9F, 0.2F}, {0.2F, 0.3F, 1}};
  Things things = someThings(83);
  for (const Shape shape : {Shape::sprite, Shape::sphere, Shape::mesh}) {
    const int samples = shape == Shape::sphere ? 1 : 4;
    CAPTURE(static_cast<int>(shape));
    const auto pictureOf = [&](const Things& all, const std::vector<std::size_t>& ends) {
      std::deque<InstanceStage> groups = grouped(all, ends);
      sim::Drawables drawables;
      for (InstanceStage& group : groups) {
        group.instances.shape = shape;
        group.instances.mesh = file;
        group.instances.additive = shape == Shape::sprite;
        group.instances.turning = sim::Instances::Turning::velocity;
        group.instances.size = 0.25F;
        group.instances.massExponent = 1.0F / 3;
        group.instances.colorBy = sim::Instances::ColorBy::speed;
        group.instances.colorRange = {0, 1.5F};
        group.instances.colors = &colors;
        group.material.roughness = 0.3F;
        group.material.metallic = 0.4F;
        drawables.instances.push_back(group.instances);
      }
      return drawn(dealtScene(), drawables, pictureSize, samples).bytes;
    };
    const std::vector<std::uint8_t> wanted = pictureOf(things, {83});
    CHECK(wanted != pictureOf(things, {60}));
    CHECK(wanted == pictureOf(things, {1, 31, 82, 83}));
    Things turned = things;
    std::reverse(turned.places.begin(), turned.places.end());
    std::reverse(turned.speeds.begin(), turned.speeds.end());
    CHECK(wanted == pictureOf(turned, {52, 83}));
  }
}

TEST_CASE("exact parts: triangles as one surface, as several or in the other order have the same bytes") {
  testContext();
  Dice dice(43);
  std::vector<glm::vec3> places;
  std::vector<glm::vec3> directions;
  std::vector<unsigned> corners;
  for (unsigned i = 0; i < 150; ++i) {
    const float reach = i % 13 == 0 ? 1.1F : i % 4 == 0 ? 0.02F : 0.3F;
    const glm::vec3 middle = 1.6F * dice.cube() + glm::vec3(0, 1.4F, 0);
    for (unsigned k = 0; k < 3; ++k) {
      places.push_back(middle + reach * dice.cube());
      directions.push_back(glm::normalize(dice.cube() + glm::vec3(0, 1.8F, 0)));
      corners.push_back(3 * i + k);
    }
  }
  const auto pictureOf = [&](const std::vector<unsigned>& of, const std::vector<std::size_t>& ends,
                             int samples) {
    std::deque<TriangleStage> stages;
    sim::Drawables drawables;
    std::size_t from = 0;
    for (const std::size_t end : ends) {
      stages.emplace_back(places,
                          std::vector(of.begin() + static_cast<std::ptrdiff_t>(3 * from),
                                      of.begin() + static_cast<std::ptrdiff_t>(3 * end)),
                          directions);
      stages.back().surface.doubleSided = true;
      stages.back().material.roughness = 0.3F;
      from = end;
    }
    for (TriangleStage& stage : stages) drawables.surfaces.push_back(stage.surface);
    return drawn(dealtScene(), drawables, pictureSize, samples).bytes;
  };
  std::vector<unsigned> turned;
  for (std::size_t i = 150; i-- > 0;)
    for (std::size_t k = 0; k < 3; ++k) turned.push_back(corners[3 * i + k]);
  for (const int samples : {1, 4}) {
    CAPTURE(samples);
    const std::vector<std::uint8_t> wanted = pictureOf(corners, {150}, samples);
    CHECK(wanted != pictureOf(corners, {140}, samples));
    CHECK(wanted == pictureOf(corners, {1, 70, 149, 150}, samples));
    CHECK(wanted == pictureOf(turned, {81, 150}, samples));
  }
}

TEST_CASE("exact parts: a surface's colours are its own after others, by palette") {
  testContext();
  scene::Scene scene = dealtScene();
  scene.sun.shadow = false;  // The sun's shadow map is fitted to all objects, including hidden ones, so it
                             // would change the picture.
  const std::vector<glm::vec4> colors = {{0.9F, 0.1F, 0.1F, 1}, {0.1F, 0.9F, 0.2F, 1}, {0.2F, 0.3F, 1, 1}};
  const auto buffer = gl::Buffer::of<glm::vec4>("palette", colors);
  const gl::Texture palette = gl::Texture::view("palette", GL_RGBA32F, buffer);
  Dice dice(47);
  std::vector<glm::vec3> places;
  std::vector<unsigned> corners;
  for (unsigned i = 0; i < 60; ++i) {
    const glm::vec3 middle = i % 3 == 0 ? dice.cube() : places[i - i % 3];
    places.push_back(middle + 0.3F * dice.cube() + glm::vec3(0, i % 3 == 0 ? 0.9F : 0, 0));
    corners.push_back(i);
  }
  TriangleStage coloured(places, corners);
  std::vector<glm::vec4> texels;
  for (std::size_t i = 0; i < places.size(); ++i)
    texels.emplace_back(places[i], static_cast<float>(i / 3 % 3));
  coloured.positions.write(0, std::as_bytes(std::span(texels)));
  coloured.surface.doubleSided = true;
  coloured.surface.palette = &palette;
  // A surface that is hidden below the ground.
  TriangleStage hidden({{-1, -3, 0}, {1, -3, 0}, {0, -3, 1}, {0, -4, 0}, {0, -5, 0}}, {0, 1, 2});
  const auto picture = [&](const std::vector<sim::Surface>& surfaces) {
    return drawn(scene, {.surfaces = surfaces}, pictureSize, 4).bytes;
  };
  const auto wanted = picture({coloured.surface});
  CHECK(picture({hidden.surface, coloured.surface}) == wanted);
  coloured.surface.palette = nullptr;
  CHECK(picture({coloured.surface}) != wanted);
}
