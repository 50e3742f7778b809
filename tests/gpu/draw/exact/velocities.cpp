// Tests the velocity layer with rotating, falling and static objects.
#include "draw/exact/motion/velocities.hpp"

#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr double fps = 30;

scene::Scene movingScene(const std::string& objects, const std::string& camera = "") {
  return scene::parseScene(
      fmt::format(
          R"({{"version": 1, "stage": false, "render": {{"size": [96, 54], "samples": 1}}, "time": {{"fps": {}}},
                  "camera": {{"position": [0, 0.3, 3], "target": [0, 0, 0]{}}}, "sun": {{"shadow": false}},
                  "objects": {{{}}}}})",
          fps, camera, objects),
      "scene.json", {}, sim::kinds());
}

draw::PictureLayers layersAt(const scene::Scene& scene, int frame) {
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, scene.render.samples);
  renderer.keepLayers({{draw::Layer::velocity, draw::Layer::position, draw::Layer::depth}, false, 32});
  frame::followMotion(renderer, world);
  world.advanceTo(frame);
  frame::drawWorld(renderer, world);
  return renderer.takeLayers();
}

glm::dvec3 threeAt(const std::vector<float>& three, std::size_t pixel) {
  return {static_cast<double>(three[3 * pixel]), static_cast<double>(three[3 * pixel + 1]),
          static_cast<double>(three[3 * pixel + 2])};
}

/// Returns the max difference between the velocities and `expected(position)` over all non-empty pixels.
template <class Expected>
double worst(const draw::PictureLayers& layers, int& seen, const Expected& expected) {
  double maximum = 0;
  for (std::size_t i = 0; i < layers.depth.size(); ++i) {
    const glm::dvec3 velocity = threeAt(layers.velocity, i);
    if (!std::isfinite(layers.depth[i])) {
      CHECK(velocity == glm::dvec3(0));
      continue;
    }
    ++seen;
    maximum = std::max(maximum, glm::length(velocity - expected(threeAt(layers.position, i))));
  }
  return maximum;
}

}  // namespace

TEST_CASE("velocities: a turning rod's are omega x r, by how far it has come in a frame") {
  testContext();
  constexpr double omega = 5.235987755982988;  // 300 degrees per second about z
  const std::string rod =
      R"("rod": {"capsule": {"rotation": {"keys": [[0, [0, 0, 0]], [1, [0, 0, 300]]]}, "radius": 0.1, "length": 0.8}})";
  const auto expected = [&](const glm::dvec3& p) {
    // Computes the position in the previous frame by rotating backwards.
    const double c = std::cos(omega / fps), s = std::sin(omega / fps);
    return (p - glm::dvec3(c * p.x + s * p.y, -s * p.x + c * p.y, p.z)) * fps;
  };
  const draw::PictureLayers layers = layersAt(movingScene(rod), 7);
  int seen = 0;
  CHECK(worst(layers, seen, expected) < 2e-3);
  CHECK(seen > 100);
  // The velocity differs from omega x r by a term of second order in the rotation angle per frame.
  int again = 0;
  const double off =
      worst(layers, again, [&](const glm::dvec3& p) { return omega * glm::dvec3(-p.y, p.x, 0); });
  CHECK(off < 0.55 * omega * omega / fps * 0.5);
  CHECK(off > 0.1);  // The difference shows that the velocity follows the chord, not the tangent.
  int still = 0;
  CHECK(worst(layersAt(movingScene(rod), 0), still, [](const auto&) { return glm::dvec3(0); }) == 0);
  CHECK(still > 80);
}

TEST_CASE("velocities: balls have their own, what stands none, whatever the camera does") {
  testContext();
  const std::string moved =
      R"("ball": {"sphere": {"radius": 0.3, "position": {"keys": [[0, [-0.5, 0, 0]], [2, [1.5, 1, -1]]]}}})";
  int seen = 0;
  CHECK(worst(layersAt(movingScene(moved), 9), seen, [](const auto&) { return glm::dvec3(1, 0.5, -0.5); }) <
        2e-4);
  CHECK(seen > 100);
  // The velocities are the same at the middle of a shutter's exposure time, and with a moving camera.
  int blurred = 0;
  CHECK(worst(layersAt(
                  movingScene(moved, R"(, "shutter": {"samples": 3}, "roll": {"keys": [[0, 0], [1, 90]]})"),
                  9),
              blurred, [](const auto&) { return glm::dvec3(1, 0.5, -0.5); }) < 2e-4);
  CHECK(blurred > 100);
  int standing = 0;
  CHECK(worst(layersAt(movingScene(R"("ball": {"sphere": {"radius": 0.5}})"), 5), standing,
              [](const auto&) { return glm::dvec3(0); }) == 0);
  CHECK(standing > 100);
}

TEST_CASE("velocities: a falling sheet's are those of its particles") {
  testContext();
  const draw::PictureLayers layers = layersAt(
      movingScene(
          R"("sheet": {"cloth": {"size": [9, 9], "pins": [], "damping": 0, "wind": [0, 0, 0], "substeps": 32}})"),
      6);
  int seen = 0;
  // The mean velocity between frames 5 and 6 is g times the middle of that interval.
  const double off =
      worst(layers, seen, [](const glm::dvec3& /*p*/) { return glm::dvec3(0, -9.8 * 5.5 / fps, 0); });
  CHECK(off < 0.03);
  CHECK(seen > 20);
}

TEST_CASE("layers: triangles and balls count from the first of their object") {
  testContext();
  // The sheet is drawn after another surface and before the balls.
  const std::string objects =
      R"("first": {"sphere": {"radius": 0.2, "position": [-1, 0, 0]}},
         "sheet": {"mesh": {"shape": "plane", "size": [1, 0, 1], "resolution": [2, 2], "rotation": [60, 0, 0]}},
         "dust": {"particles": {"groups": [{"shape": "ball", "count": 5, "radius": 0.2, "position": [1, 0, 0]}], "method": "none", "look": {"size": 0.2}}})";
  const scene::Scene scene = movingScene(objects);
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, scene.render.samples);
  renderer.keepLayers({{draw::Layer::primitive, draw::Layer::position, draw::Layer::object}, false, 32});
  frame::drawWorld(renderer, world);
  const draw::PictureLayers layers = renderer.takeLayers();
  std::set<std::uint32_t> ofSheet, ofDust, beyond;
  int mixed = 0;
  std::array<int, 2> sides{};
  for (std::size_t i = 0; i < layers.primitive.size(); ++i) {
    const std::uint32_t number = layers.primitive[i];
    const draw::PictureLayers::ObjectCoverage& share =
        layers.shares[i * static_cast<std::size_t>(layers.ranks)];
    const std::string object = share.coverage > 0 ? layers.objects[share.object] : "";
    if (object.empty()) beyond.insert(number);
    if (object == "dust") ofDust.insert(number);
    if (object != "sheet") continue;
    ofSheet.insert(number);
    // z coordinate in the sheet's local space, downwards along the sheet. Pixels near the diagonals |x| =
    // |z| are ignored.
    const glm::dvec3 p = threeAt(layers.position, i);
    const double down = p.y / -std::sin(3.14159265358979 / 3);
    if (std::abs(p.x - down) > 0.02 && std::abs(p.x + down) > 0.02) {
      const bool byDifference = p.x > down, bySum = p.x + down > 0;
      sides[0] += byDifference == (number == 0) ? 1 : -1;
      sides[1] += bySum == (number == 0) ? 1 : -1;
      ++mixed;
    }
  }
  CHECK(beyond == std::set<std::uint32_t>{draw::PictureLayers::noPrimitive});
  CHECK(ofSheet == std::set<std::uint32_t>{0, 1});
  CHECK(*ofDust.rbegin() < 5);
  CHECK(ofDust.size() >= 3);
  CHECK(mixed > 100);
  // At all pixels, one of the two diagonals separates the triangles.
  CHECK(std::max(std::abs(sides[0]), std::abs(sides[1])) == mixed);
}

TEST_CASE("velocities: shares of corners") {
  const glm::dvec3 a(0), b(2, 0, 0), c(0, 0, 3);
  CHECK(glm::length(draw::barycentricWeights(a, b, c, {0.5, 7, 0.75}) - glm::dvec3(0.5, 0.25, 0.25)) <
        1e-12);
  CHECK(draw::barycentricWeights(a, b, c, {-4, 0, -1}) == glm::dvec3(1, 0, 0));
  CHECK(draw::barycentricWeights(a, b, b, {1, 0, 0}) == glm::dvec3(1, 0, 0));
}
