// Tests orthographic cameras. Picture positions must be linear in space, and light, shadows and path
// tracing must agree with a very distant perspective camera.
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr glm::ivec2 frameSize(96, 54);
constexpr double height = 2.4;
const glm::dvec3 eye(2.1, 1.8, 3.2), target(0.1, 0.1, 0);

struct Axes {
  glm::dvec3 forward = glm::normalize(target - eye);
  glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
  glm::dvec3 up = glm::cross(right, forward);
};

/// Returns the picture position of a point (pixels from the top left corner).
glm::dvec2 seenAt(const glm::dvec3& p) {
  const Axes axes;
  const double perMetre = frameSize.y / height;
  return {0.5 * frameSize.x + perMetre * glm::dot(p - eye, axes.right),
          0.5 * frameSize.y - perMetre * glm::dot(p - eye, axes.up)};
}

constexpr const char* things =
    R"("ball": {"sphere": {"radius": 0.4, "position": [-0.5, 0.4, 0]}, "material": {"color": [0.7, 0.3, 0.2], "roughness": 0.4}},
       "ring": {"mesh": {"shape": "torus", "radius": 0.45, "tube": 0.14, "position": [0.6, 0.5, -0.2], "rotation": [70, 20, 0]}},
       "dust": {"particles": {"groups": [{"shape": "ball", "count": 60, "radius": 1.1}], "method": "none", "look": {"size": 0.09}}})";

/// Returns a scene. `camera`: members of the camera object; `render`: additional members of the render
/// object.
scene::Scene sceneOf(const std::string& camera, const std::string& render, const std::string& objects) {
  return scene::parseScene(
      fmt::format(
          R"({{"version": 1, "stage": false, "render": {{"size": [{}, {}]{}}}, "time": {{"fps": 30}},
                  "camera": {{{}}}, "sun": {{"direction": [0.5, 0.9, 0.2]}},
                  "ground": {{"height": 0, "fadeStart": 2, "fadeEnd": 2.6}}, "objects": {{{}}}}})",
          frameSize.x, frameSize.y, render, camera, objects),
      "scene.json", {}, sim::kinds());
}

std::string flatCamera(const std::string& more = "") {
  return fmt::format(R"("position": [{}, {}, {}], "target": [{}, {}, {}], "projection": "orthographic",
                        "height": {}, "near": 0.5, "far": 9{})",
                     eye.x, eye.y, eye.z, target.x, target.y, target.z, height, more);
}

/// Returns a perspective camera with an angle of view of one degree. The camera is so far away that it
/// shows the same area around the target.
std::string farCamera() {
  const double away = 0.5 * height / std::tan(0.5 * 0.017453292519943295);
  const glm::dvec3 there = target - away * Axes().forward;
  const double nearest = away - glm::length(target - eye) + 0.5;
  return fmt::format(
      R"("position": [{}, {}, {}], "target": [{}, {}, {}], "fieldOfView": 1, "near": {}, "far": {})",
      there.x, there.y, there.z, target.x, target.y, target.z, nearest, nearest + 9);
}

draw::PictureLayers layersAt(const scene::Scene& scene, int frame, std::vector<draw::Layer> wanted) {
  testContext();
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, scene.render.samples);
  renderer.keepLayers({std::move(wanted), false, 32});
  frame::followMotion(renderer, world);
  world.advanceTo(frame);
  frame::drawWorld(renderer, world);
  return renderer.takeLayers();
}

glm::dvec3 at(const std::vector<float>& three, std::size_t pixel) {
  return {static_cast<double>(three[3 * pixel]), static_cast<double>(three[3 * pixel + 1]),
          static_cast<double>(three[3 * pixel + 2])};
}

/// Mean difference of light between two pictures, and mean light.
struct PixelDifference {
  double off = 0, mean = 0;
};
PixelDifference pixelDifference(const std::string& render, const std::string& objects) {
  const draw::PictureLayers flat = layersAt(sceneOf(flatCamera(), render, objects), 0, {});
  const draw::PictureLayers far = layersAt(sceneOf(farCamera(), render, objects), 0, {});
  PixelDifference found;
  for (std::size_t i = 0; i < flat.light.size(); ++i) {
    if (i % 4 == 3) continue;
    found.off += std::abs(static_cast<double>(flat.light[i] - far.light[i])) /
                 static_cast<double>(flat.light.size());
    found.mean += static_cast<double>(flat.light[i]) / static_cast<double>(flat.light.size());
  }
  return found;
}

}  // namespace

TEST_CASE("orthographic: a place's pixel is linear in it, and depth is the way along the line of sight") {
  const draw::PictureLayers layers = layersAt(sceneOf(flatCamera(), ", \"samples\": 1", things), 0,
                                              {draw::Layer::position, draw::Layer::depth});
  int seen = 0, onBall = 0, onGround = 0;
  double off = 0, deep = 0, round = 0;
  for (std::size_t i = 0; i < layers.depth.size(); ++i) {
    if (!std::isfinite(layers.depth[i])) continue;
    ++seen;
    const glm::dvec3 p = at(layers.position, i);
    const glm::dvec2 pixel(static_cast<double>(i % frameSize.x) + 0.5,
                           static_cast<double>(i / frameSize.x) + 0.5);
    off = std::max(off, glm::length(seenAt(p) - pixel));
    deep =
        std::max(deep, std::abs(glm::dot(p - eye, Axes().forward) - static_cast<double>(layers.depth[i])));
    const double away = glm::length(p - glm::dvec3(-0.5, 0.4, 0)) - 0.4;
    onBall += std::abs(away) < 0.004 ? 1 : 0;
    onGround += std::abs(p.y) < 1e-4 ? 1 : 0;
    round = std::min(round, away);
  }
  CHECK(off < 1e-3);
  CHECK(deep < 1e-5);
  CHECK(seen > 2500);
  CHECK(onBall > 150);
  CHECK(onGround > 700);
  CHECK(round > -0.03);  // the position may be nearer because of facets and of samples at pixel edges
}

TEST_CASE("orthographic: the picture is that of a camera far away") {
  for (const char* quality :
       {R"("draft")", R"("standard", "occlusionRadius": 0.5)", R"("high", "raySamples": 16)"}) {
    CAPTURE(quality);
    const PixelDifference found = pixelDifference(fmt::format(R"(, "quality": {})", quality), things);
    CHECK(found.off < 0.025 * found.mean);
    CHECK(found.mean > 0.1);
  }
  const PixelDifference glows = pixelDifference(
      "",
      R"("dust": {"particles": {"groups": [{"shape": "ball", "count": 40, "radius": 1.1}], "method": "none",
             "look": {"size": 0.2, "additive": true}}})");
  CHECK(glows.off < 0.025 * glows.mean);
}

TEST_CASE("orthographic: the ground is there where it lies behind the plane of the camera, too") {
  // With `back` 0, the camera is 1.5 m above the ground. The picture is 6 m high, so the lowest rays start
  // below the ground.
  const auto sceneAt = [](double back) {
    const glm::dvec3 low(0, 1.5, 6);
    const glm::dvec3 there = low + back * glm::normalize(low);
    return scene::parseScene(
        fmt::format(
            R"({{"version": 1, "stage": false, "render": {{"size": [96, 54], "samples": 1}}, "time": {{"fps": 30}},
                  "camera": {{"projection": "orthographic", "height": 6, "position": [{}, {}, {}], "target": [0, 0, 0]}},
                  "sun": {{"direction": [0.5, 0.9, 0.2]}}, "ground": {{"height": 0, "fadeStart": 60, "fadeEnd": 80}},
                  "objects": {{{}}}}})",
            there.x, there.y, there.z, things),
        "scene.json", {}, sim::kinds());
  };
  const glm::dvec3 low(0, 1.5, 6), forward = -glm::normalize(low);
  const std::vector<draw::Layer> wanted = {draw::Layer::depth, draw::Layer::position};
  const draw::PictureLayers near = layersAt(sceneAt(0), 0, wanted), far = layersAt(sceneAt(20), 0, wanted);
  int behind = 0, ground = 0;
  double off = 0, deep = 0, light = 0;
  for (std::size_t i = 0; i < near.depth.size(); ++i) {
    REQUIRE(std::isfinite(near.depth[i]) == std::isfinite(far.depth[i]));
    for (std::size_t c = 0; c < 3; ++c)
      light = std::max(light, std::abs(static_cast<double>(near.light[4 * i + c] - far.light[4 * i + c])));
    if (!std::isfinite(near.depth[i])) continue;
    const glm::dvec3 p = at(near.position, i);
    off = std::max(off, glm::length(p - at(far.position, i)));
    deep = std::max(deep, std::abs(glm::dot(p - low, forward) - static_cast<double>(near.depth[i])));
    ground += std::abs(p.y) < 1e-4 ? 1 : 0;
    behind += near.depth[i] < 0 ? 1 : 0;
  }
  CHECK(ground > 2000);
  CHECK(behind > 500);
  CHECK(off < 2e-3);
  CHECK(deep < 1e-4);
  CHECK(light < 0.05);
}

TEST_CASE("orthographic: what has holes or is blended, and copies of meshes, are where they are") {
  const PixelDifference found = pixelDifference(
      "",
      R"("pane": {"mesh": {"shape": "plane", "size": [1, 0, 1], "position": [0.3, 0.8, 0.2], "rotation": [50, 30, 0]},
             "material": {"color": [0.2, 0.5, 0.9], "alpha": "blend", "opacity": 0.4}},
             "rocks": {"particles": {"groups": [{"shape": "ball", "count": 12, "radius": 1}], "method": "none",
             "look": {"size": 0.15, "shape": "sphere"}}})");
  CHECK(found.off < 0.02 * found.mean);
}

TEST_CASE(
    "vectors: from where a point is seen to where it was a frame before, by its motion and the camera's") {
  const std::string ball =
      R"("ball": {"sphere": {"radius": 0.4, "position": {"keys": [[0, [-0.5, 0, 0]], [2, [1.5, 1, -1]]]}}})";
  constexpr double fps = 30;
  const glm::dvec3 way = glm::dvec3(1, 0.5, -0.5) / fps;
  const auto pixelOf = [](const glm::dvec3& from, double scale, const glm::dvec3& p) {
    const glm::dvec3 forward = glm::normalize(-from),
                     right = glm::normalize(glm::cross(forward, {0, 1, 0}));
    const glm::dvec3 up = glm::cross(right, forward);
    const double deep = scale > 0 ? 1 / scale : glm::dot(p - from, forward) * std::tan(0.3490658503988659);
    return 0.5 * frameSize.y * glm::dvec2(glm::dot(p - from, right), glm::dot(p - from, up)) / deep;
  };
  for (const bool flat : {false, true}) {
    CAPTURE(flat);
    const scene::Scene scene = sceneOf(
        std::string(
            R"("position": {"keys": [[0, [2, 1, 3]], [1, [-1, 2, 3]]]}, "target": [0, 0, 0], "far": 20)") +
            (flat ? R"(, "projection": "orthographic", "height": 2.5)" : ""),
        "", ball);
    const draw::PictureLayers layers = layersAt(
        scene, 9, {draw::Layer::vector, draw::Layer::position, draw::Layer::velocity, draw::Layer::depth});
    const auto eyeAt = [](double frame) {
      return glm::dvec3(2, 1, 3) + frame / fps * glm::dvec3(-3, 1, 0);
    };
    double off = 0;
    int moving = 0, standing = 0;
    for (std::size_t i = 0; i < layers.depth.size(); ++i) {
      if (!std::isfinite(layers.depth[i])) continue;
      const glm::dvec3 p = at(layers.position, i);
      const bool moves = glm::length(at(layers.velocity, i)) > 0;
      (moves ? moving : standing) += 1;
      const double scale = flat ? 2 / 2.5 : 0;
      const glm::dvec2 expected =
          pixelOf(eyeAt(8), scale, moves ? p - way : p) - pixelOf(eyeAt(9), scale, p);
      const glm::dvec2 found(static_cast<double>(layers.vector[2 * i]),
                             static_cast<double>(layers.vector[2 * i + 1]));
      off = std::max(off, glm::length(found - expected));
    }
    CHECK(off < 5e-3);
    CHECK(moving > 100);
    CHECK(standing > 500);
  }
}
