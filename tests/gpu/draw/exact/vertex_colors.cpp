// Tests vertex colours and materials of mesh files. The result must be the same on static, deformed,
// skinned and floating meshes and on cloth.
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "gpu/context.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "scene/load.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "unit/figure_text.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec3.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Returns the colour at a position. The function is affine, so the colour does not depend on the
/// triangulation.
glm::dvec3 colorAt(double x, double y) {
  return {0.5 + 0.4 * x, 0.5 + 0.2 * x - 0.3 * y, 0.4 + 0.4 * y};
}
const glm::dvec3 left(0.5, 1, 0.75),
    right(1, 0.25, 0.5);  // base colours of the materials of the two halves

/// Returns a glTF square from -1 to 1 in the xy plane that faces +z and has two materials. `bones`: true
/// for a skeleton of one static bone.
std::string squareText(bool bones) {
  test::GltfText gltf;
  constexpr int side = 5;
  nlohmann::json primitives;
  for (const int half : {0, 1}) {
    std::vector<float> places, weights;
    std::vector<std::uint16_t> colors, corners;
    std::vector<std::uint8_t> joints;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const double x = half - 1 + i / (side - 1.0), y = 2.0 * j / (side - 1) - 1;
        places.insert(places.end(), {static_cast<float>(x), static_cast<float>(y), 0});
        for (int k = 0; k < 3; ++k)
          colors.push_back(static_cast<std::uint16_t>(std::lround(65535 * colorAt(x, y)[k])));
        colors.push_back(65535);
        weights.insert(weights.end(), {1, 0, 0, 0});
        joints.insert(joints.end(), {0, 0, 0, 0});
        if (i + 1 == side || j + 1 == side) continue;
        for (const int corner : {j * side + i, j * side + i + 1, j * side + i + side, j * side + i + 1,
                                 j * side + i + side + 1, j * side + i + side})
          corners.push_back(static_cast<std::uint16_t>(corner));
      }
    nlohmann::json attributes = {{"POSITION", gltf.floats(places, "VEC3", 3)},
                                 {"COLOR_0", gltf.add(colors, 5123, "VEC4", 4, true)}};
    if (bones) attributes["JOINTS_0"] = gltf.add(joints, 5121, "VEC4", 4);
    if (bones) attributes["WEIGHTS_0"] = gltf.floats(weights, "VEC4", 4);
    primitives.push_back({{"attributes", attributes},
                          {"indices", gltf.add(corners, 5123, "SCALAR", 1)},
                          {"material", half}});
  }
  auto& d = gltf.document;
  d["scene"] = 0;
  d["scenes"] = {{{"nodes", bones ? nlohmann::json{0, 1} : nlohmann::json{0}}}};
  d["nodes"] = {{{"name", "square"}, {"mesh", 0}}};
  if (bones) {
    d["nodes"][0]["skin"] = 0;
    d["nodes"].push_back({{"name", "bone"}});
    d["skins"] = {{{"joints", {1}}}};
  }
  d["meshes"] = {{{"primitives", primitives}}};
  const auto material = [](const glm::dvec3& c) {
    return nlohmann::json{
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {c.r, c.g, c.b, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}}};
  };
  d["materials"] = {material(left), material(right)};
  return gltf.text();
}

/// Returns the max difference between the albedo of the object's pixels and the closed form. `seen`: number
/// of pixels that show the object.
double farthest(const std::string& object, const std::string& fileText, bool materials, int& seen) {
  testContext();
  const test::TemporaryFile file("square.gltf", fileText);
  const scene::Scene scene =
      scene::parseScene(fmt::format(R"({{"version": 1, "render": {{"size": [48, 48], "samples": 1}},
                  "camera": {{"position": [0, 0, 3], "target": [0, 0, 0], "projection": "orthographic", "height": 2.2}},
                  "objects": {{"square": {{{}}}}}}})",
                                    fmt::format(fmt::runtime(object), file.path().filename().string())),
                        file.path().parent_path() / "scene.json", {}, sim::kinds());
  sim::World world(scene);
  draw::Renderer renderer(scene, scene.render.size, 1);
  renderer.keepLayers({{draw::Layer::albedo, draw::Layer::position, draw::Layer::depth}, false, 32});
  frame::drawWorld(renderer, world);
  const draw::PictureLayers layers = renderer.takeLayers();
  double off = 0;
  seen = 0;
  for (std::size_t i = 0; i < layers.depth.size(); ++i) {
    if (!std::isfinite(layers.depth[i])) continue;
    const double x = static_cast<double>(layers.position[3 * i]),
                 y = static_cast<double>(layers.position[3 * i + 1]);
    if (std::abs(x) < 0.03 || std::abs(x) > 0.97 || std::abs(y) > 0.97) continue;
    ++seen;
    const glm::dvec3 expected = colorAt(x, y) * (!materials ? glm::dvec3(1) : x < 0 ? left : right);
    for (int k = 0; k < 3; ++k)
      off = std::max(off, std::abs(static_cast<double>(layers.albedo[3 * i + static_cast<std::size_t>(k)]) -
                                   expected[k]));
  }
  return off;
}

}  // namespace

TEST_CASE("vertex colours multiply a file's materials, interpolated, whatever becomes of the mesh") {
  int seen = 0;
  for (const char* object :
       {R"("mesh": {{"shape": "file", "file": "{}"}})",
        R"("mesh": {{"shape": "file", "file": "{}", "deform": [{{"ripple": {{"amplitude": 0.001}}}}]}})",
        R"("mesh": {{"shape": "file", "file": "{}", "technique": "vertex-shader",
                                 "deform": [{{"ripple": {{"amplitude": 0.001}}}}]}})",
        R"("cloth": {{"mesh": {{"file": "{}"}}, "pins": []}})",
        R"("water": {{"size": [8, 8], "cell": 1, "position": [0, -5, 0],
                      "floats": [{{"shape": "box", "drawn": "{}", "position": [0, 5, 0]}}]}})"}) {
    CAPTURE(object);
    CHECK(farthest(object, squareText(false), true, seen) < 2e-3);
    CHECK(seen > 1500);
  }
  CHECK(farthest(R"("body": {{"file": "{}"}})", squareText(true), true, seen) < 2e-3);
  CHECK(seen > 1500);
}

TEST_CASE("vertex colours multiply the scene's own material instead, and those of PLY are sRGB") {
  int seen = 0;
  CHECK(farthest(R"("mesh": {{"shape": "file", "file": "{}"}}, "material": {{"color": [1, 1, 1]}})",
                 squareText(false), false, seen) < 2e-3);
  CHECK(seen > 1500);
  CHECK(farthest(R"("water": {{"size": [8, 8], "cell": 1, "position": [0, -5, 0],
      "floats": [{{"shape": "box", "drawn": "{}", "position": [0, 5, 0], "color": [1, 1, 1]}}]}})",
                 squareText(false), false, seen) < 2e-3);
  CHECK(seen > 1500);
  testContext();
  const test::TemporaryFile file("one.ply", R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 1
property list uchar int vertex_indices
end_header
-3 -3 0 188 255 0
3 -3 0 188 255 0
0 5 0 188 255 0
3 0 1 2
)");
  const sim::Mesh mesh = sim::loadMesh(file.path());
  REQUIRE(mesh.colors.size() == 3);
  CHECK(mesh.colors[0].r == doctest::Approx(0.50289));  // ((188 / 255 + 0.055) / 1.055)^2.4
  CHECK(mesh.colors[0].g == 1);
  CHECK(mesh.colors[0].b == 0);
}

TEST_CASE("vertex colours: the driver's picture is the exact one within its rounding, edges apart") {
  testContext();
  GridStage sheet({3, 3}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  sheet.material.color = glm::vec3(0.8F, 0.9F, 1);
  sheet.material.roughness = 1;
  const glm::vec4 west(1, 0.1F, 0, 1), east(0.2F, 0.6F, 0.4F, 1), between = 0.5F * (west + east);
  sheet.tint({west, between, east, west, between, east, west, between, east});
  const auto by = [&](scene::Rasterizer rasterizer) {
    return drawn(darkScene(), {.surfaces = {sheet.surface}}, {64, 64}, 4, {.rasterizer = rasterizer});
  };
  const Picture exact = by(scene::Rasterizer::exact), driver = by(scene::Rasterizer::driver);
  int worst = 0;
  for (int y = 24; y < 40; ++y)
    for (int x = 24; x < 40; ++x)
      for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(exact.at(x, y)[k] - driver.at(x, y)[k]));
  CHECK(worst <= 2);
  CHECK(driver.at(24, 32).r > driver.at(39, 32).r + 5);
  CHECK(driver.at(24, 32).g < driver.at(39, 32).g - 5);
}
