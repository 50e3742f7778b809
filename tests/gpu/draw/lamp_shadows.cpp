// Tests shadows of a scene's lights by comparison with geometry computed by hand.
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/lamp_stage.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <array>
#include <memory>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns a square sheet that is perpendicular to `direction` and whose centre is at `distance` metres
/// along `direction`. `side`: side length in metres.
GridStage across(glm::vec3 direction, float distance, float side) {
  const glm::vec3 helper = std::abs(direction.y) > 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(helper, direction));
  const glm::vec3 down = glm::cross(right, direction);
  return GridStage({5, 7}, distance * direction - 0.5F * side * (right + down), side * right, side * down);
}

/// Returns the directions of all faces, edges and corners of the cube of shadow maps.
std::vector<glm::vec3> directions() {
  std::vector<glm::vec3> all;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) all.push_back(glm::normalize(glm::vec3(x, y, z)));
  return all;
}

/// Returns a scene whose camera faces the back of a translucent screen, which a lamp at the origin lights.
/// 4 m on the screen span 65 pixels.
scene::Scene screened(glm::vec3 direction, bool shadow) {
  scene::Scene scene = darkScene();
  scene.camera.position = 12.0F * direction;
  scene.camera.target = glm::vec3(0);
  scene.camera.fieldOfView = 2.0F * std::atan(2.0F / 10.0F) * 57.29577951F;
  scene.sun.intensity = 0.0F;
  scene.lights = {lampAt({0, 0, 0}, 40, shadow)};
  return scene;
}

}  // namespace

TEST_CASE("lights: a sheet's shadow lies at its projection from the lamp") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({0.4F, 2, -0.2F}, 20, true)};
  GridStage sheet({8, 8}, {-0.6F, 1, -0.5F}, {1.2F, 0, 0}, {0, 0, 1});
  sheet.material.color = glm::vec3(0.0F);
  for (const float softness : {1.5F, 3.0F}) {
    scene.lights[0].shadowSoftness = softness;
    const Picture lit = drawn(scene, {}, {129, 129});
    const Picture shaded = drawn(scene, {.surfaces = {sheet.surface}}, {129, 129});
    // The ground is twice as far from the lamp as the sheet, so the shadow is twice as large as the sheet.
    const glm::dvec2 low(0.4 + 2 * (-0.6 - 0.4), -0.2 + 2 * (-0.5 + 0.2));
    const glm::dvec2 high(0.4 + 2 * (0.6 - 0.4), -0.2 + 2 * (0.5 + 0.2));
    int inside = 0;
    for (int y = 0; y < 129; ++y)
      for (int x = 0; x < 129; ++x) {
        const glm::dvec3 p = placeOf(x, y, 129);
        // distance from the shadow's edge in metres; positive inside the shadow
        const double depth =
            std::min(std::min(p.x - low.x, high.x - p.x), std::min(p.z - low.y, high.y - p.z));
        // seen from above, the sheet hides the ground here
        const bool hidden = std::abs(p.x) < 0.75 && std::abs(p.z) < 0.65;
        if (hidden || std::abs(depth) < 0.07) continue;
        const int light = shaded.brightness(x, y);
        if (depth > 0)
          REQUIRE(light < 12);
        else
          REQUIRE(std::abs(light - lit.brightness(x, y)) < 12);
        inside += depth > 0 ? 1 : 0;
      }
    CHECK(inside > 500);
  }
}

TEST_CASE("lights: shadows are correct on all six cube faces and across their edges and corners") {
  testContext();
  for (const glm::vec3& direction : directions()) {
    CAPTURE(direction.x);
    CAPTURE(direction.y);
    CAPTURE(direction.z);
    GridStage screen = across(direction, 2, 4);
    screen.material.translucency = 1;
    screen.material.color = glm::vec3(1);
    GridStage caster = across(direction, 1, 1);
    const Picture plain = drawn(screened(direction, false), {.surfaces = {screen.surface}}, {65, 65}, 1);
    const scene::Scene scene = screened(direction, true);
    // Without a shadow, the screen has no seams and no shadow acne.
    const Picture lit = drawn(scene, {.surfaces = {screen.surface}}, {65, 65}, 1);
    CHECK(plain.brightness(32, 32) > 600);
    for (int y = 2; y < 63; ++y)
      for (int x = 2; x < 63; ++x) REQUIRE(std::abs(lit.brightness(x, y) - plain.brightness(x, y)) < 9);
    // A sheet of 1 m at a distance of 1 m casts a shadow of 2 m at 2 m, which is half of the screen's 65
    // pixels.
    const Picture shaded = drawn(scene, {.surfaces = {screen.surface, caster.surface}}, {65, 65}, 1);
    for (int y = 2; y < 63; ++y)
      for (int x = 2; x < 63; ++x) {
        const double out = std::max(std::abs(x - 32), std::abs(y - 32)) - 65 / 4.0;
        if (std::abs(out) < 1.5) continue;
        if (out < 0)
          REQUIRE(shaded.brightness(x, y) < 9);
        else
          REQUIRE(std::abs(shaded.brightness(x, y) - plain.brightness(x, y)) < 9);
      }
  }
}

TEST_CASE("lights: shadow edges are smooth ramps") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({0, 2, 0}, 20, true)};
  scene.lights[0].shadowSize = 64;
  GridStage half({3, 3}, {0.2F, 0.5F, -3}, {4, 0, 0}, {0, 0, 6});
  half.material.color = glm::vec3(0);  // The ground is black, because a bright border next to the shadow
                                       // would be the largest step.
  scene.camera.position = glm::vec3(-4, 20, 0);  // The camera is next to the sheet.
  scene.camera.target = glm::vec3(-0.01F, 0, 0);
  const Picture picture = drawn(scene, {.surfaces = {half.surface}}, {257, 65}, 1);
  int largest = 0;
  int between = 0;
  const int y = 32;
  for (int x = 1; x < 257; ++x) {
    const int here = picture.brightness(x, y);
    largest = std::max(largest, std::abs(here - picture.brightness(x - 1, y)));
    between += here > 60 && here < 300 ? 1 : 0;
  }
  CHECK(between >= 3);
  CHECK(largest < 260);
}

TEST_CASE("lights: no shadow acne under grazing light, on coarse maps and on round shapes") {
  testContext();
  const auto pixelDifference = [](scene::Scene& scene, const sim::Drawables& drawables) {
    scene.lights[0].shadow = false;
    const Picture plain = drawn(scene, drawables, {97, 97});
    scene.lights[0].shadow = true;
    const Picture shaded = drawn(scene, drawables, {97, 97});
    CHECK(plain.brightness(48, 48) > 60);
    return compare(shaded, plain).far;
  };
  scene::Scene scene = fromAbove();
  scene.ground.reset();  // Removes the ground, because the sheet casts a shadow on it.
  scene.lights = {lampAt({-2.6F, 1.25F, 0.3F}, 60, true)};
  scene.lights[0].shadowSize = 64;
  GridStage wide({33, 33}, {-3, 1, -3}, {6, 0, 0}, {0, 0, 6});
  CHECK(pixelDifference(scene, {.surfaces = {wide.surface}}) == 0);
  // The camera is distant, so it sees the ball with fewer facets than the shadow maps of the nearby lamp.
  InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0, 1, 0)));
  ball.instances.shape = sim::Instances::Shape::sphere;
  ball.instances.size = 1.1F;
  scene.lights = {lampAt({0, 1.95F, 0}, 3, true)};
  scene.lights[0].shadowSize = 1024;
  scene.lights[0].shadowSoftness = 0.5F;
  CHECK(pixelDifference(scene, {.instances = {ball.instances}}) == 0);
}

TEST_CASE("lights: a shadow starts at the foot of a standing object") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({-3, 2, 0}, 60, true)};
  GridStage wall({3, 3}, {0, 1, -1}, {0, -1, 0}, {0, 0, 2});  // a vertical wall in the plane x = 0
  wall.material.color = glm::vec3(0.0F);
  const Picture picture = drawn(scene, {.surfaces = {wall.surface}}, {129, 129});
  // At this distance, a shadow texel is 1.4 cm wide and a pixel is 6.2 cm wide.
  for (const int x : {66, 68, 75, 90}) CHECK(picture.brightness(x, 64) < 12);
  CHECK(picture.brightness(62, 64) > 150);
}

TEST_CASE("lights: geometry inside a lamp's radius casts no shadow") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({0, 1, 0}, 20, true)};
  SphereStage shade({0, 1, 0}, 0.2F);
  shade.surface.doubleSided = true;
  CHECK(drawn(scene, {.surfaces = {shade.surface}}, {65, 65}).brightness(50, 32) < 12);
  scene.lights[0].radius = 0.21F;
  CHECK(drawn(scene, {.surfaces = {shade.surface}}, {65, 65}).brightness(50, 32) > 150);
}

TEST_CASE("lights: shadow maps are cleared each frame and follow a moving lamp") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({0, 2, 0}, 20, true)};
  scene.lights[0].position = scene::Animated<glm::vec3>(
      {{0, glm::vec3(-1, 2, 0)}, {1, glm::vec3(1, 2, 0.5F)}}, scene::Ease::linear);
  GridStage sheet({4, 4}, {-0.5F, 1, -0.5F}, {1, 0, 0}, {0, 0, 1});
  const sim::Drawables drawables{.surfaces = {sheet.surface}};
  const auto at = [&](const std::vector<double>& times) {
    draw::Renderer renderer(scene, {65, 65}, 1, testOptions());
    draw::Readback readback({65, 65});
    for (const double time : times) renderer.draw(time, drawables);
    readback.start(renderer.target(), 0);
    return readback.nextPicture(true).value().second;
  };
  CHECK(at({0.0, 0.25, 1.0}) == at({1.0}));
  CHECK(at({0.0}) != at({1.0}));
}

TEST_CASE(
    "lights: surfaces displaced by vertex shaders are lit and cast shadows like those displaced by "
    "kernels") {
  testContext();
  const auto shown = [](const char* technique) {
    scene::Scene scene = scene::parseScene(
        std::string(
            R"({"version": 1, "stage": false, "ground": {"height": -1}, "sun": {"intensity": 0, "shadow": false},
          "camera": {"position": [0, 4, 5]}, "lights": {"a": {"position": [0.7, 1.2, 0.4], "glow": 0, "intensity": 30}},
          "objects": {"sheet": {"mesh": {"resolution": [41, 37], "size": [2, 0, 2],
            "deform": [{"ripple": {"amplitude": 0.3, "wavelength": 1.5}}], "technique": ")") +
            technique + "\"}}}}",
        "s.json", {}, sim::kinds());
    sim::World world(scene);
    world.advanceTo(5);
    return drawn(scene, world.drawables(), {129, 97});
  };
  const Picture kernel = shown("compute");
  CHECK(kernel.brightness(64, 48) > 60);
  const Difference d = compare(shown("vertex-shader"), kernel);
  CHECK(d.mean < 0.1);
  CHECK(d.far < 8);
}

TEST_CASE("lights: scenes of hundreds of surfaces and of none have correct shadows") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({0, 3, 0}, 40, true), lampAt({1, 3, 1}, 40, true)};
  std::vector<std::unique_ptr<GridStage>> tiles;
  sim::Drawables many;
  for (int i = 0; i < 67; ++i) {
    const float x = static_cast<float>(i % 9) * 0.4F - 1.8F;
    const float z = static_cast<float>(i / 9) * 0.4F - 1.8F;
    tiles.push_back(std::make_unique<GridStage>(glm::ivec2(2, 2), glm::vec3(x, 1, z), glm::vec3(0.4F, 0, 0),
                                                glm::vec3(0, 0, 0.4F)));
    tiles.back()->surface.material = &tiles[0]->material;
    many.surfaces.push_back(tiles.back()->surface);
  }
  many.surfaces.resize(63);
  GridStage whole({10, 8}, {-1.8F, 1, -1.8F}, {3.6F, 0, 0}, {0, 0, 2.8F});
  draw::Renderer renderer(scene, {97, 97}, 1, testOptions());
  draw::Readback readback({97, 97});
  const auto shown = [&](const sim::Drawables& drawables) {
    renderer.draw(0, drawables);
    readback.start(renderer.target(), 0);
    return Picture{{97, 97}, readback.nextPicture(true).value().second};
  };
  const Picture none = shown({});
  const Picture tiled = shown(many);
  CHECK(compare(tiled, none).far > 500);
  CHECK(compare(shown({.surfaces = {whole.surface}}), tiled).far < 30);
  CHECK(shown({}).bytes == none.bytes);
}

TEST_CASE("lights: only the triangles that the GPU counted cast shadows") {
  testContext();
  scene::Scene scene = fromAbove();
  scene.lights = {lampAt({0, 2, 0}, 20, true)};
  GridStage sheet({2, 4}, {-0.5F, 1, -1.5F}, {1, 0, 0}, {0, 0, 3});  // a sheet of three quads
  GridStage first({2, 2}, {-0.5F, 1, -1.5F}, {1, 0, 0}, {0, 0, 1});
  const std::array<unsigned, 5> six = {6, 1, 0, 0, 0};
  const gl::Buffer arguments = gl::Buffer::of<unsigned>("arguments", six);
  const Picture whole = drawn(scene, {.surfaces = {sheet.surface}}, {97, 97}, 1);
  sheet.surface.arguments = &arguments;
  const Picture part = drawn(scene, {.surfaces = {sheet.surface}}, {97, 97}, 1);
  CHECK(part.bytes == drawn(scene, {.surfaces = {first.surface}}, {97, 97}, 1).bytes);
  CHECK(part.bytes != whole.bytes);
}

TEST_CASE("lights: objects with shadows off are drawn but block no lamp or sun light") {
  testContext();
  GridStage sheet({3, 3}, {-0.4F, 1, -0.4F}, {0.8F, 0, 0}, {0, 0, 0.8F});
  InstanceStage balls(std::vector<glm::vec3>{{0, 1, 1.5F}, {0, 1, -1.5F}});
  InstanceStage sprites(std::vector<glm::vec3>{{0.5F, 1, 1.5F}});
  balls.instances.shape = sim::Instances::Shape::sphere;
  balls.instances.size = sprites.instances.size = 0.8F;
  const std::pair<scene::Material*, sim::Drawables> casters[] = {
      {&sheet.material, {.surfaces = {sheet.surface}}},
      {&balls.material, {.instances = {balls.instances}}},
      {&sprites.material, {.instances = {sprites.instances}}}};
  for (const bool lamp : {false, true})
    for (const auto& [material, drawables] : casters) {
      scene::Scene scene = fromAbove();
      if (lamp) scene.lights = {lampAt({1.5F, 2.5F, 0}, 30, true)};
      scene.sun.intensity = lamp ? 0.0F : 3.0F;
      scene.sun.direction = glm::vec3(1, 1, 0);
      scene.sun.shadow = !lamp;
      material->castsShadow = true;
      const Picture with = drawn(scene, drawables, {129, 129}, 1);
      material->castsShadow = false;
      const Picture without = drawn(scene, drawables, {129, 129}, 1);
      if (lamp)
        scene.lights[0].shadow = false;
      else
        scene.sun.shadow = false;
      const Picture unshadowed = drawn(scene, drawables, {129, 129}, 1);
      int shaded = 0;
      int other = 0;
      for (int y = 0; y < 129; ++y)
        for (int x = 0; x < 129; ++x) {
          shaded += with.brightness(x, y) < unshadowed.brightness(x, y) - 60 ? 1 : 0;
          other += std::abs(without.brightness(x, y) - unshadowed.brightness(x, y)) > 12 ? 1 : 0;
        }
      CHECK(shaded > 60);
      CHECK(other == 0);
    }
}
