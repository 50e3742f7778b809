// Tests shading and shadows of the sun by comparison with geometry computed by hand.
#include "gpu/draw/instance_stage.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Returns a scene with the camera straight above the plane y = 0. The picture's top points to -z, and 64
/// pixels span 8 m.
scene::Scene groundScene(glm::vec3 sun) {
  scene::Scene scene = darkScene();
  scene.camera.position = glm::vec3(0, 20, 0);
  scene.camera.fieldOfView = 2.0F * std::atan(4.0F / 20.0F) * 57.29577951F;
  scene.sun.direction = sun;
  scene.ground.emplace();
  scene.ground->height = 0;
  scene.ground->fadeStart = 1000;
  scene.ground->fadeEnd = 2000;
  return scene;
}

}  // namespace

TEST_CASE("a matt sheet facing the sun has its own colour on both sides, with and without shadows") {
  testContext();
  for (const bool shadow : {true, false})
    for (const float side : {1.0F, -1.0F}) {
      CAPTURE(shadow);
      CAPTURE(side);
      scene::Scene scene = darkScene();
      scene.sun.shadow = shadow;
      scene.sun.direction = glm::vec3(0, 0, side);
      scene.camera.position = glm::vec3(0, 0, 5 * side);
      GridStage sheet({9, 7}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
      sheet.material.color = glm::vec3(0.5F, 0.25F, 0.1F);
      sheet.material.roughness = 1.0F;
      const Picture picture = drawn(scene, {.surfaces = {sheet.surface}}, {65, 65});
      // Specular part of the sun's light: F0 / 4 at roughness 1, if light, view and normal are aligned.
      const double mirrored = 0.04 / 4;
      CHECK(near(picture.at(32, 32), filmByte({0.5 + mirrored, 0.25 + mirrored, 0.1 + mirrored}), 2.5));
      // Normals at the borders (one-sided differences) equal those in the middle.
      const int middle = picture.brightness(32, 32);
      for (const auto& [x, y] : {std::pair{16, 16}, {48, 16}, {16, 48}, {48, 48}, {32, 16}, {16, 32}})
        CHECK(std::abs(picture.brightness(x, y) - middle) < 12);
    }
}

TEST_CASE("light from behind passes only through translucent cloth") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.direction = glm::vec3(0, 0, -1);
  GridStage sheet({4, 4}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  sheet.material.color = glm::vec3(0.8F);
  CHECK(drawn(scene, {.surfaces = {sheet.surface}}, {33, 33}).brightness(16, 16) < 6);
  sheet.material.translucency = 0.5F;
  const Picture picture = drawn(scene, {.surfaces = {sheet.surface}}, {33, 33});
  CHECK(near(picture.at(16, 16), filmByte({0.4, 0.4, 0.4}), 2.5));
}

TEST_CASE("the lobe of translucent cloth fades where the sun grazes it") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  scene.sun.direction = glm::normalize(glm::vec3(1, 0, 0.2F));
  scene.camera.position = glm::vec3(-5, 0, 2);
  GridStage sheet({4, 4}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  sheet.material.color = glm::vec3(0);
  sheet.material.roughness = 0.7F;
  const int opaque = drawn(scene, {.surfaces = {sheet.surface}}, {33, 33}).brightness(16, 16);
  CHECK(opaque > 250);
  sheet.material.translucency = 0.5F;
  const int grazed = drawn(scene, {.surfaces = {sheet.surface}}, {33, 33}).brightness(16, 16);
  CHECK(grazed < opaque / 2);
  // In steeper light, the lobes are equal.
  scene.sun.direction = glm::normalize(glm::vec3(1, 0, 0.7F));
  const Picture lit = drawn(scene, {.surfaces = {sheet.surface}}, {33, 33});
  sheet.material.translucency = 0.0F;
  CHECK(lit.at(16, 16) == drawn(scene, {.surfaces = {sheet.surface}}, {33, 33}).at(16, 16));
}

TEST_CASE("metal reflects the sky, tinted by its colour") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.intensity = 0.0F;
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(1);
  GridStage sheet({4, 4}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  sheet.material.color = glm::vec3(0.9F, 0.5F, 0.1F);
  sheet.material.metallic = 1;
  sheet.material.roughness = 0.2F;
  const glm::ivec3 c = drawn(scene, {.surfaces = {sheet.surface}}, {33, 33}).at(16, 16);
  CHECK(near(c, filmByte({0.9, 0.5, 0.1}), 16));
}

TEST_CASE("a sheet's shadow lies at its projection from the sun") {
  testContext();
  // The sun is at 45 degrees on the +x side, so a point at a height of 2 m shades the ground 2 m further
  // towards -x.
  const scene::Scene scene = groundScene(glm::vec3(1, 1, 0));
  GridStage sheet({8, 8}, {0.5F, 2, -1}, {2, 0, 0}, {0, 0, 2});
  for (const int samples : {1, 4}) {
    const Picture picture = drawn(scene, {.surfaces = {sheet.surface}}, {64, 64}, samples);
    const auto ground = [&](float x, float z) {
      return picture.brightness(32 + static_cast<int>(std::floor(x * 8)),
                                32 + static_cast<int>(std::floor(z * 8)));
    };
    // The shadow spans x from -1.5 to 0.5 and z from -1 to 1. Seen from above, the sheet hides x > 0.55.
    const int lit = ground(-3, 3);
    CHECK(lit > 200);
    for (const float x : {-1.3F, -0.5F, 0.3F})
      for (const float z : {-0.8F, 0.0F, 0.8F}) CHECK(ground(x, z) < lit / 8);
    for (const auto& [x, z] :
         {std::pair{-1.8F, 0.0F}, {-0.5F, 1.3F}, {-0.5F, -1.3F}, {3.5F, 0.0F}, {0.0F, 3.0F}})
      CHECK(std::abs(ground(x, z) - lit) < 12);
  }
}

TEST_CASE("disabling the sun's shadow removes it, and a lit sheet shows no shadow acne") {
  testContext();
  scene::Scene scene = groundScene(glm::vec3(1, 1, 0));
  GridStage sheet({8, 8}, {0.5F, 2, -1}, {2, 0, 0}, {0, 0, 2});
  scene.sun.shadow = false;
  const Picture plain = drawn(scene, {.surfaces = {sheet.surface}}, {64, 64});
  CHECK(std::abs(plain.brightness(28, 32) - plain.brightness(8, 56)) < 12);
  // Even under grazing light and with a coarse shadow map, the whole sheet must be lit.
  scene = groundScene(glm::vec3(1, 0.12F, 0.3F));
  scene.sun.shadowSize = 128;
  GridStage wide({8, 8}, {-3, 1, -3}, {6, 0, 0}, {0, 0, 6});
  const Picture lit = drawn(scene, {.surfaces = {wide.surface}}, {64, 64});
  const int middle = lit.brightness(32, 32);
  CHECK(middle > 20);
  for (int y = 12; y < 52; ++y)
    for (int x = 12; x < 52; ++x) CHECK(std::abs(lit.brightness(x, y) - middle) < 30);
}

TEST_CASE("nothing of the previous frame remains in a picture, also behind glows") {
  testContext();
  const scene::Scene scene = darkScene();
  GridStage sheet({4, 4}, {-1.5F, -1.5F, 0}, {3, 0, 0}, {0, 3, 0});
  GridStage aside({4, 4}, {-3, -1, 0}, {2, 0, 0}, {0, 1.5F, 0});
  InstanceStage glow(std::vector<glm::vec3>(1, glm::vec3(0.3F)));
  glow.instances.additive = true;
  for (const auto shape : {sim::Instances::Shape::sprite, sim::Instances::Shape::sphere})
    for (const int samples : {1, 4}) {
      glow.instances.shape = shape;
      const sim::Drawables last = {.surfaces = {aside.surface}, .instances = {glow.instances}};
      draw::Renderer renderer(scene, {65, 47}, samples, testOptions());
      draw::Readback readback({65, 47});
      sim::Drawables first = last;
      first.instances[0].brightness = 5000;
      renderer.draw(0, first);
      renderer.draw(0, {.surfaces = {sheet.surface}});
      renderer.draw(0, last);
      readback.start(renderer.target(), 0);
      CHECK(readback.nextPicture(true).value().second == drawn(scene, last, {65, 47}, samples).bytes);
    }
}

TEST_CASE("nothing of the previous frame remains in the shadow map") {
  testContext();
  const scene::Scene scene = groundScene(glm::vec3(0.001F, 1, 0));
  GridStage far({4, 4}, {50, 2, 50}, {2, 0, 0}, {0, 0, 2});
  GridStage sheet({4, 4}, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2});
  sheet.surface.model[3].x = 1.0F;
  draw::Renderer renderer(scene, {64, 64}, 1, testOptions());
  draw::Readback readback({64, 64});
  Picture pictures[2];
  for (Picture& picture : pictures) {
    renderer.draw(0, {.surfaces = {&picture == &pictures[0] ? far.surface : sheet.surface}});
    readback.start(renderer.target(), 0);
    picture = {{64, 64}, readback.nextPicture(true).value().second};
  }
  const Picture fresh = drawn(scene, {.surfaces = {sheet.surface}}, {64, 64}, 1);
  CHECK(fresh.bytes == pictures[1].bytes);
}
