// Tests overlays, the layer of texture coordinates, and panels.
#include "base/srgb.hpp"
#include "draw/exact/scene/overlaid_things.hpp"
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "gpu/context.hpp"
#include "scene/load.hpp"
#include "scene/panels.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec3.hpp>

using namespace simreel;  // NOLINT

namespace overlay_tests {

constexpr int side = 48;
constexpr const char* ball = R"("a": {"sphere": {"radius": 1}})";
constexpr const char* sheet =
    R"("a": {"mesh": {"size": [2, 2], "resolution": [3, 3], "rotation": [90, 0, 0]}, "material": {"color": "white"}})";

/// Returns a scene that an orthographic camera sees along -z; the picture is 4 m high. `render` and `rest`:
/// further members of "render" and of the scene.
scene::Scene sceneOf(const std::string& objects, const std::string& render, const std::string& rest = "") {
  return scene::parseScene(
      fmt::format(R"({{"version": 2, "render": {{"size": [{0}, {0}], "samples": 1{1}}}, {2} "camera":
                  {{"position": [0, 0, 9], "target": [0, 0, 0], "projection": "orthographic", "height": 4}},
                  "objects": {{{3}}}}})",
                  side, render, rest, objects),
      "scene.json", {}, sim::kinds());
}

struct Drawn {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> bytes;
  [[nodiscard]] glm::ivec3 at(int x, int y) const {
    const auto i = static_cast<std::size_t>(4 * (y * size.x + x));
    return {bytes[i], bytes[i + 1], bytes[i + 2]};
  }
};

Drawn pictureOf(const scene::Scene& scene) {
  testContext();
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, scene.render.samples);
  draw::Readback readback(scene.render.size);
  frame::drawWorld(renderer, world);
  readback.start(renderer.target(), 0);
  return {scene.render.size, readback.nextPicture(true).value().second};
}

draw::PictureLayers layersOf(const scene::Scene& scene, std::vector<draw::Layer> layers) {
  testContext();
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, 1);
  renderer.keepLayers({std::move(layers), false, 32});
  frame::drawWorld(renderer, world);
  return renderer.takeLayers();
}

/// Returns the largest difference of a pixel from an expected colour (0 to 255).
double pixelDifference(const glm::ivec3& found, const glm::dvec3& expected) {
  double maximum = 0;
  for (int k = 0; k < 3; ++k) maximum = std::max(maximum, std::abs(found[k] - expected[k]));
  return maximum;
}

TEST_CASE("the overlay of normals shows 0.5 + 0.5 n of the layer of normals, and only that") {
  const Drawn overlay = pictureOf(sceneOf(ball, R"(, "overlay": "normals", "exposure": 3, "vignette": 1)"));
  const draw::PictureLayers layers =
      layersOf(sceneOf(ball, R"(, "quality": "draft")", R"("ground": false,)"), {draw::Layer::normal});
  int seen = 0;
  double off = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto i = static_cast<std::size_t>(3 * (y * side + x));
      const glm::dvec3 n(layers.normal[i], layers.normal[i + 1], layers.normal[i + 2]);
      if (n == glm::dvec3(0)) continue;
      ++seen;
      off = std::max(off, pixelDifference(overlay.at(x, y), 127.5 + 127.5 * n));
    }
  CHECK(seen > 400);
  CHECK(off < 1.6);  // dither and rounding
}

TEST_CASE(
    "an overlay is the same picture in all qualities, whatever lights the scene, also through glass") {
  const std::string two =
      std::string(ball) +
      R"(, "pane": {"disc": {"radius": 0.8, "position": [0, 0, 1.5], "rotation": [90, 0, 0]},
                               "material": {"opacity": 0.3, "alpha": "blend"}},
               "dust": {"particles": {"groups": [{"count": 40, "radius": 1.5}], "method": "none", "look": {"size": 0.1}}},
               "rocks": {"particles": {"groups": [{"count": 9, "radius": 1.8}], "method": "none",
                                       "look": {"shape": "mesh", "mesh": "meshes/boat.obj", "size": 0.3}}})";
  for (const char* name : {"wireframe", "normals", "uv", "objects"}) {
    CAPTURE(name);
    const Drawn draft =
        pictureOf(sceneOf(two, fmt::format(R"(, "overlay": "{}", "quality": "draft")", name)));
    for (const char* quality : {"standard", "high"}) {
      const Drawn other = pictureOf(sceneOf(
          two,
          fmt::format(R"(, "overlay": "{}", "quality": "{}", "bloom": {{"strength": 1}})", name, quality),
          R"("sun": {"intensity": 9}, "lights": {"l": {"position": [0, 0, 3], "intensity": 50}},)"));
      CHECK(other.bytes == draft.bytes);
    }
  }
}

TEST_CASE("the layer uv holds the texture coordinates of a sheet, and the overlay their checker") {
  const draw::PictureLayers layers = layersOf(sceneOf(sheet, ""), {draw::Layer::uv});
  const Drawn overlay = pictureOf(sceneOf(sheet, R"(, "overlay": "uv")"));
  double off = 0;
  int dark = 0, bright = 0;
  for (int y = 13; y < side - 13; ++y)
    for (int x = 13; x < side - 13; ++x) {
      const auto i = static_cast<std::size_t>(2 * (y * side + x));
      const double u = (x + 0.5 - 12) / 24, v = (y + 0.5 - 12) / 24;
      off = std::max({off, std::abs(static_cast<double>(layers.uv[i]) - u),
                      std::abs(static_cast<double>(layers.uv[i + 1]) - v)});
      (overlay.at(x, y).z < 115 ? dark : bright) += 1;
    }
  CHECK(off < 1e-4);
  CHECK(std::abs(dark - bright) < 60);
}

TEST_CASE("the overlay of objects gives each object its colour, also where surfaces are joined") {
  std::string objects;
  for (int i = 0; i < 4; ++i)
    objects += fmt::format(R"({}"o{}": {{"box": {{"size": [0.8, 0.8, 0.8], "position": [{}, 0, 0]}}}})",
                           i > 0 ? ", " : "", i, i - 1.5);
  const Drawn overlay = pictureOf(sceneOf(objects, R"(, "overlay": "objects")"));
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 light = draw::objectColor(static_cast<std::size_t>(i));
    glm::dvec3 expected;
    for (int k = 0; k < 3; ++k) expected[k] = 255 * srgbOfLinear(static_cast<double>(light[k]));
    CHECK(pixelDifference(overlay.at(6 + 12 * i, side / 2), expected) < 1.6);
  }
}

TEST_CASE("the overlay wireframe draws the edges of triangles and keeps the colour between them") {
  const Drawn overlay = pictureOf(sceneOf(sheet, R"(, "overlay": "wireframe")"));
  CHECK(overlay.at(24, 20).x < 170);  // the edges in the middle
  CHECK(overlay.at(20, 23).x < 170);
  CHECK(overlay.at(21, 18).x + overlay.at(15, 18).x > 400);  // inside two triangles
  CHECK(overlay.at(2, 2).x < 60);                            // the background
}

TEST_CASE("an overlay with the driver's rasterizer is refused") {
  CHECK_THROWS(sceneOf(ball, R"(, "overlay": "uv", "rasterizer": "driver")"));
}

TEST_CASE("panels show the pictures of their cameras, overlays and objects side by side") {
  const std::string two =
      std::string(ball) + R"(, "b": {"box": {"position": [0, 1.5, 0], "size": [0.5, 0.5, 0.5]}})";
  const std::string panels =
      R"("panels": {"one": {"caption": ""}, "two": {"view": "right", "overlay": "normals", "caption": "", "objects": ["b"]}},)";
  const scene::Scene both = sceneOf(two, "", panels);
  const scene::PanelGrid grid = scene::panelGrid({side, side}, 2);
  REQUIRE(grid.columns == 1);
  REQUIRE(grid.cell.y == (side - grid.gap) / 2);
  const Drawn found = pictureOf(both);
  scene::Scene first = sceneOf(two, "");
  first.render.size = grid.cell;
  const Drawn expected = pictureOf(first);
  bool same = true;
  for (int y = 0; y < grid.cell.y; ++y)
    for (int x = 0; x < grid.cell.x; ++x) same = same && found.at(x, y) == expected.at(x, y);
  CHECK(same);
  // The second panel shows the box alone, from the right.
  const int below = grid.cell.y + grid.gap;
  CHECK(pixelDifference(found.at(side / 2, below + grid.cell.y / 2), glm::dvec3(found.at(2, below + 2))) <=
        1);
  CHECK(pixelDifference(found.at(side / 2, below + 5), {255, 127.5, 127.5}) < 1.6);
}

TEST_CASE("panels refuse names of objects that do not exist, and layers") {
  CHECK_THROWS(sceneOf(ball, "", R"("panels": {"p": {"objects": ["aa"]}},)"));
  const scene::Scene scene = sceneOf(ball, "", R"("panels": {"p": "top"},)");
  testContext();
  draw::Renderer renderer(scene, scene.render.size, 1);
  CHECK_THROWS(renderer.keepLayers({{draw::Layer::depth}, false, 32}));
}

}  // namespace overlay_tests
