// Tests triplanar textures of surfaces without uvs, and the relief from texture brightness.
#include "gpu/draw/ball_stage.hpp"
#include "gpu/draw/image_file.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// A ball of radius 1 without uvs; its texture repeats every two metres.
struct Ball {
  explicit Ball(const std::string& texture) : stage(glm::vec3(0), 1) {
    stage.surface.uvs = nullptr;
    stage.material.color = glm::vec3(0.3F);
    stage.material.texture = texture;
    stage.material.textureScale = glm::vec3(0.5F);
  }
  SphereStage stage;
};

/// Draws the ball from the side `direction`. The ball is at the picture's centre.
Picture seenFrom(const Ball& ball, glm::vec3 direction, glm::vec3 light) {
  scene::Scene scene = darkScene();
  scene.camera.position = 5.0F * direction;
  scene.camera.fieldOfView = 25;
  scene.sun.direction = light;
  scene.sun.shadow = false;
  return drawn(scene, {.surfaces = {ball.stage.surface}}, {129, 129}, 1);
}

bool isMaximum(glm::ivec3 c, int channel) {
  return c[channel] > c[(channel + 1) % 3] + 60 && c[channel] > c[(channel + 2) % 3] + 60;
}

}  // namespace

TEST_CASE("textures without uv: a triplanar texture is upright and not mirrored from all sides") {
  testContext();
  // The upper texels are red and green, and the lower texels are blue and white.
  const ImageFile file(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255});
  const Ball ball(file.path());
  for (const glm::vec3& side : {glm::vec3(0, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 0, -1),
                                glm::vec3(-1, 0, 0), glm::vec3(0.001F, 1, 0.05F)}) {
    CAPTURE(side.x);
    CAPTURE(side.y);
    CAPTURE(side.z);
    const Picture picture = seenFrom(ball, side, side);
    // The texture's origin is at the ball's centre. The texture's first texel is to the right of the origin
    // and below it.
    CHECK(isMaximum(picture.at(64 + 29, 64 + 29), 0));
    CHECK(isMaximum(picture.at(64 - 29, 64 + 29), 1));
    CHECK(isMaximum(picture.at(64 + 29, 64 - 29), 2));
    CHECK(picture.brightness(64 - 29, 64 - 29) > 300);
  }
}

TEST_CASE("relief of a texture: bright texels are raised, and slopes facing the light are brighter") {
  testContext();
  // The centre of the white texel is 0.25 m to the right of the middle. The centres of grey texels are 0.75
  // m to the right and 0.25 m to the left of the middle.
  const ImageFile file(2, 1, {255, 255, 255, 255, 128, 128, 128, 255});
  Ball ball(file.path());
  ball.stage.material.textureScale = glm::vec3(1);
  const auto brightness = [&](float bump, int x) {
    ball.stage.material.bump = bump;
    return seenFrom(ball, {0, 0, 1}, {1, 0, 1}).brightness(x, 64);
  };
  const int rising = 64;
  const int falling = 64 + 29;  // pixel column 0.5 m to the right of the middle
  CHECK(brightness(0.5F, rising) < brightness(0, rising) - 15);
  CHECK(brightness(-0.5F, rising) > brightness(0, rising) + 5);
  CHECK(brightness(0.5F, falling) > brightness(-0.5F, falling) + 5);
}

TEST_CASE(
    "relief of a texture: a slope of hundreds of pixels is shaded evenly, except within 25 pixels of its "
    "ends") {
  testContext();
  // A pixel is 2 mm wide, and a texel is 200 pixels wide. The brightness rises from grey at pixel 100 to
  // white at pixel 300.
  const ImageFile file(2, 1, {128, 128, 128, 255, 255, 255, 255, 255});
  GridStage square({2, 2}, glm::vec3(-2, 2, 0), glm::vec3(4, 0, 0), glm::vec3(0, -4, 0));
  square.material.color = glm::vec3(0.3F);
  square.material.roughness = 1;
  square.material.texture = file.path();
  // the uvs span the sheet's 4 m once, so a copy is 0.8 m wide
  square.material.textureScale = glm::vec3(5);
  scene::Scene scene = darkScene();
  scene.camera.fieldOfView = 2 * std::atan(4.5F * 0.002F / 5) * 57.29577951F;
  scene.sun.shadow = false;
  const auto pictureWith = [&](float bump) {
    square.material.bump = bump;
    return drawn(scene, {.surfaces = {square.surface}}, {401, 9}, 1);
  };
  // Returns the albedo, including the specular reflection straight back, F0 / 4.
  const auto albedo = [](int x) { return 0.01 + 0.3 * (0.21586 + 0.78414 * (x + 0.5 - 100.5) / 200); };
  const auto byteOf = [](double light) { return filmByte({light, light, light})[1]; };
  for (const float bump : {0.0F, 1.0F}) {
    const Picture picture = pictureWith(bump);
    double low = 0;
    double high = 4;  // Finds the fraction of the light that the slope reflects, by bisection.
    for (int i = 0; i < 40; ++i)
      (byteOf(albedo(200) * 0.5 * (low + high)) < picture.at(200, 4).y ? low : high) = 0.5 * (low + high);
    for (const int x : {128, 140, 170, 230, 260, 272}) {
      CAPTURE(bump);
      CAPTURE(low);
      CAPTURE(x);
      CHECK(std::abs(picture.at(x, 4).y - byteOf(albedo(x) * low)) < 3);
    }
  }
  CHECK(pictureWith(1).at(200, 4).y < pictureWith(0).at(200, 4).y - 20);
}
