// Tests the renderer's finished pictures: sky, tone map, orientation, sizes, samples and limits.
#include "base/error.hpp"
#include "base/file.hpp"
#include "frame/image.hpp"
#include "gl/limits.hpp"
#include "gpu/draw/draw_stage.hpp"

#include <filesystem>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

int farthest(glm::ivec3 c, const std::array<double, 3>& wanted) {
  double max = 0;
  for (int i = 0; i < 3; ++i) max = std::fmax(max, std::abs(c[i] - wanted[static_cast<std::size_t>(i)]));
  return static_cast<int>(std::ceil(max));
}

std::string failure(const scene::Scene& scene, glm::ivec2 size, int samples, ExitCode code,
                    scene::Rasterizer rasterizer) {
  testContext();
  try {
    const draw::Renderer renderer(scene, size, samples, {.rasterizer = rasterizer});
  } catch (const UserError& error) {
    CHECK(error.code() == code);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("sRGB bytes follow the film curve over its whole range") {
  testContext();
  for (const double light : {0.0, 0.001, 0.004, 0.02, 0.1, 0.18, 0.5, 1.0, 3.0, 20.0}) {
    CAPTURE(light);
    scene::Scene scene = darkScene();
    const glm::vec3 sky(static_cast<float>(light), static_cast<float>(light * 0.5),
                        static_cast<float>(light * 0.25));
    scene.sky.zenith = sky;
    scene.sky.horizon = sky;
    scene.sky.ground = sky;
    scene.sun.intensity = 0.0F;
    const Picture picture = drawn(scene, {}, {8, 8});
    const auto wanted = filmByte({light, light * 0.5, light * 0.25});
    // The tolerance covers 1/2 for rounding, 1/2 for dithering, and the error of the approximate power
    // function.
    for (int x = 0; x < 4; ++x) CHECK(farthest(picture.at(x, 3), wanted) <= 2);
  }
}

TEST_CASE("one stop of exposure doubles the light, and the vignette darkens only the corners") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0.2F);
  scene.sun.intensity = 0.0F;
  scene.render.exposure = 1.0F;
  scene.render.vignette = 0.5F;
  const Picture picture = drawn(scene, {}, {65, 65});
  CHECK(farthest(picture.at(32, 32), filmByte({0.4, 0.4, 0.4})) <= 2);
  CHECK(farthest(picture.at(0, 0), filmByte({0.2, 0.2, 0.2})) <= 6);
}

TEST_CASE("the sky blends from zenith at the top over the horizon to the ground colour") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sky.zenith = glm::vec3(0, 0, 1);
  scene.sky.horizon = glm::vec3(0, 1, 0);
  scene.sky.ground = glm::vec3(1, 0, 0);
  scene.sun.direction = glm::vec3(0, 0, 1);
  scene.camera.fieldOfView = 120.0F;
  for (const int samples : {1, 4}) {
    const Picture picture = drawn(scene, {}, {33, 101}, samples);
    const glm::ivec3 top = picture.at(16, 0);
    const glm::ivec3 middle = picture.at(16, 50);
    const glm::ivec3 bottom = picture.at(16, 100);
    CHECK(top.z > 2 * top.x);
    CHECK(top.z > top.y);
    CHECK(middle.y > middle.x + 60);
    CHECK(middle.y > middle.z + 60);
    CHECK(bottom.x > 2 * bottom.y);
    CHECK(bottom.x > 2 * bottom.z);
  }
}

TEST_CASE("row 0 is the top and column 0 the left, at odd sizes with 1 and 4 samples") {
  testContext();
  const scene::Scene scene = darkScene();
  GridStage sheet({5, 5}, {-1.5F, 1.2F, 0}, {1.0F, 0, 0}, {0, -0.8F, 0});
  for (const int samples : {1, 4}) {
    const Picture picture = drawn(scene, {.surfaces = {sheet.surface}}, {33, 21}, samples);
    // 21 rows span 2 * 5 * tan(20 degrees) = 3.64 m, which is 5.77 pixels per metre around pixel (16, 10).
    CHECK(picture.brightness(16 - 6, 10 - 5) > 300);
    CHECK(picture.brightness(16 + 6, 10 - 5) < 10);
    CHECK(picture.brightness(16 - 6, 10 + 5) < 10);
    CHECK(picture.brightness(16 + 6, 10 + 5) < 10);
  }
}

TEST_CASE("four samples smooth an edge; one sample does not") {
  testContext();
  const scene::Scene scene = darkScene();
  GridStage sheet({2, 2}, {-1, 1, 0}, {2, 0.3F, 0}, {0.3F, -2, 0});
  int between[2] = {0, 0};
  for (const int i : {0, 1}) {
    const Picture picture = drawn(scene, {.surfaces = {sheet.surface}}, {64, 64}, i == 0 ? 1 : 4);
    const int full = picture.brightness(32, 32);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const int b = picture.brightness(x, y);
        between[i] += b > full / 8 && b < full * 7 / 8;
      }
  }
  CHECK(between[0] == 0);
  CHECK(between[1] > 40);
}

TEST_CASE("exceeding a GL limit names the limit and its value") {
  testContext();
  scene::Scene scene = darkScene();
  const int max = gl::limits().textureSize;
  for (const auto rasterizer : {scene::Rasterizer::exact, scene::Rasterizer::driver}) {
    const std::string wide = failure(scene, {max + 1, 8}, 1, ExitCode::device, rasterizer);
    CHECK(wide.find("GL_MAX_TEXTURE_SIZE") != std::string::npos);
    CHECK(wide.find(std::to_string(max)) != std::string::npos);
  }
  const std::string exact = failure(scene, {8, 8}, 3, ExitCode::usage, scene::Rasterizer::exact);
  CHECK(exact.find("3 samples per pixel: the exact rasterizer has 1, 2, 4, 8 and 16") != std::string::npos);
  const std::string samples = failure(scene, {8, 8}, 3, ExitCode::device, scene::Rasterizer::driver);
  CHECK(samples.find("set \"samples\" to 1, ") != std::string::npos);
  CHECK(samples.find("4") != std::string::npos);
  CHECK(samples.find("GL_MAX_SAMPLES") != std::string::npos);
  scene.sun.shadowSize = max + 1;
  for (const auto rasterizer : {scene::Rasterizer::exact, scene::Rasterizer::driver})
    CHECK(failure(scene, {8, 8}, 1, ExitCode::device, rasterizer).find("shadowSize") != std::string::npos);
}

TEST_CASE("a texture without repeats does not bleed across opposite borders") {
  testContext();
  // The two texels are black and white. If the texture repeated, both borders would be grey.
  const auto file = temporaryFile("two_texels.png");
  writeFileAtomically(file, frame::encodePng({2, 1, {0, 0, 0, 255, 255, 255, 255, 255}}, {}));
  GridStage stage({5, 4}, {-1, 1, 0}, {2, 0, 0}, {0, -2, 0});
  stage.material.color = glm::vec3(1);
  stage.material.texture = file;
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  const auto spread = [&](float repeats) {
    stage.material.textureScale = glm::vec3(repeats);
    const Picture picture = drawn(scene, {{stage.surface}}, {200, 200}, 1);
    int first = 0;
    int last = 0;
    for (int x = 0; x < 200; ++x) {
      if (picture.brightness(x, 100) == 0) continue;
      first = first == 0 ? x : first;
      last = x;
    }
    return glm::ivec2(picture.brightness(first, 100), picture.brightness(last, 100));
  };
  const glm::ivec2 once = spread(1);
  CHECK(once.y > 600);
  const glm::ivec2 repeated = spread(2);
  CHECK(repeated.y < once.y - 60);
  std::filesystem::remove(file);
}

TEST_CASE("a missing or broken texture file is named in the error") {
  testContext();
  scene::Scene scene = darkScene();
  scene.objects.emplace_back();
  scene.objects[0].material.texture = "/nowhere/weave.png";
  bool missing = false;
  try {
    const draw::Renderer renderer(scene, {8, 8}, 1, testOptions());
  } catch (const UserError& error) {
    missing = std::string(error.what()).find("/nowhere/weave.png") != std::string::npos;
  }
  CHECK(missing);
  const auto file = temporaryFile("broken.png");
  writeFileAtomically(file, "\x89PNG but not really");
  scene.objects[0].material.texture = file;
  CHECK(failure(scene, {8, 8}, 1, ExitCode::inputOutput, scene::Rasterizer::exact).find(file.string()) !=
        std::string::npos);
  std::filesystem::remove(file);
}

TEST_CASE("readback returns frames in order and reports when it is full") {
  testContext();
  const glm::ivec2 size{17, 5};
  draw::Renderer renderer(darkScene(), size, 1, testOptions());
  draw::Readback readback(size);
  CHECK_FALSE(readback.nextPicture(true).has_value());
  for (int round = 0; round < 3; ++round) {
    for (int tag = 0; tag < 3; ++tag) {
      CHECK_FALSE(readback.full());
      readback.start(renderer.target(), 10 * round + tag);
    }
    CHECK(readback.full());
    for (int tag = 0; tag < 3; ++tag) {
      const auto taken = readback.nextPicture(true);
      REQUIRE(taken.has_value());
      CHECK(taken->first == 10 * round + tag);
      CHECK(taken->second.size() == 17U * 5U * 4U);
    }
    CHECK(readback.empty());
  }
}
