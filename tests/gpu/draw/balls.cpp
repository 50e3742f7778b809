// Tests opaque instances and their shadows by comparison with surfaces of the same shape. Tests mesh
// instances and bloom.
#include "base/file.hpp"
#include "gpu/draw/ball_stage.hpp"

#include <filesystem>

#include <doctest/doctest.h>

using namespace simreel;
using Shape = sim::Instances::Shape;

namespace {

/// Returns a scene for a ball above the ground. The sun is at the side. The camera is near, and the ball is
/// not at the picture's centre.
scene::Scene ballScene() {
  scene::Scene scene;
  scene.camera.position = glm::vec3(0.3F, 1.6F, 4);
  scene.camera.target = glm::vec3(0, 0.5F, 0);
  scene.ground.emplace();
  scene.ground->height = 0;
  return scene;
}

/// Returns the linear grey light that the film curve maps to `byte`.
double lightOf(int byte) {
  double low = 0;
  double high = 4;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (filmByte({middle, middle, middle})[1] < byte ? low : high) = middle;
  }
  return high;
}

std::filesystem::path temporaryMesh(const char* name, const char* text) {
  auto file = temporaryFile(name);
  writeFileAtomically(file, text);
  return file;
}

}  // namespace

TEST_CASE("an instance drawn as sphere or sprite, with its shadow, equals a sphere mesh") {
  testContext();
  for (const int samples : {1, 4})
    for (const float roughness : {0.25F, 0.9F}) {
      CAPTURE(samples);
      CAPTURE(roughness);
      const scene::Scene scene = ballScene();
      SphereStage sphere({-0.4F, 0.9F, 0.2F}, 0.6F);
      sphere.material.roughness = roughness;
      const Picture wanted = drawn(scene, {{sphere.surface}, {}}, {161, 121}, samples);
      const Picture empty = drawn(scene, {}, {161, 121}, samples);
      CHECK(compare(wanted, empty).far > 2000);
      InstanceStage group({{-0.4F, 0.9F, 0.2F, 8}, {-0.4F, 0.9F, 0.2F, 1}}, {glm::vec4(0), {0, 0, 0, -1}});
      group.instances.size = 0.6F;
      group.instances.massExponent = 1.0F / 3;
      group.material.roughness = roughness;
      for (const Shape shape : {Shape::sphere, Shape::sprite}) {
        CAPTURE(static_cast<int>(shape));
        group.instances.shape = shape;
        const Difference d = compare(drawn(scene, {{}, {group.instances}}, {161, 121}, samples), wanted);
        CHECK(d.mean < 0.25);
        // Only pixels along silhouettes differ, because they are partly covered.
        CHECK(d.far < 60);
      }
    }
}

TEST_CASE("explicit bounds give the same shadow as measured bounds") {
  testContext();
  const scene::Scene scene = ballScene();
  InstanceStage group(std::vector<glm::vec3>(1, glm::vec3(-0.4F, 0.9F, 0.2F)));
  group.instances.size = 1.2F;
  const Picture measured = drawn(scene, {{}, {group.instances}}, {161, 121});
  group.instances.boundsMin = glm::vec3(-1.0F, 0.3F, -0.4F);
  group.instances.boundsMax = glm::vec3(0.2F, 1.5F, 0.8F);
  const Difference d = compare(drawn(scene, {{}, {group.instances}}, {161, 121}), measured);
  CHECK(d.mean < 0.1);
  CHECK(d.far < 20);
}

TEST_CASE("additive and dead instances cast no shadow") {
  testContext();
  const scene::Scene scene = ballScene();
  const Picture empty = drawn(scene, {}, {65, 49});
  InstanceStage dead({{0, 1, 0, 1}}, {{0, 0, 0, -1}});
  dead.instances.size = 1;
  CHECK(drawn(scene, {{}, {dead.instances}}, {65, 49}).bytes == empty.bytes);
  InstanceStage glow(std::vector<glm::vec3>(1, glm::vec3(0, 1, 0)));
  glow.instances.size = 1;
  glow.instances.additive = true;
  glow.instances.brightness = 0;
  CHECK(drawn(scene, {{}, {glow.instances}}, {65, 49}).bytes == empty.bytes);
}

TEST_CASE("light per ball area is continuous across the levels of detail") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  scene.sun.intensity = 1.0F;
  // Returns the total light in the picture divided by the squared radius of the ball. The radius is around
  // 1.6 pixels, the limit for small balls.
  const auto light = [&](float pixels) {
    const float metres = pixels / (0.5F * 257 / std::tan(0.5F * 0.6981317F)) * 5;
    std::vector<glm::vec3> places;
    for (int y = -4; y <= 4; ++y)
      for (int x = -4; x <= 4; ++x)
        places.emplace_back(static_cast<float>(x) * 0.1513F, static_cast<float>(y) * 0.1471F, 0);
    InstanceStage balls(places);
    balls.instances.size = 2 * metres;
    balls.material.color = glm::vec3(0.5F);
    const Picture p = drawn(scene, {{}, {balls.instances}}, {257, 257});
    double sum = 0;
    for (int y = 0; y < 257; ++y)
      for (int x = 0; x < 257; ++x) sum += p.at(x, y).y > 3 ? lightOf(p.at(x, y).y) : 0;
    return sum / (static_cast<double>(pixels) * static_cast<double>(pixels));
  };
  const double fine = light(1.7F);
  // Large balls lose a little light, because pixels on the outline are shaded at the outline.
  CHECK(light(1.5F) == doctest::Approx(fine).epsilon(0.1));
  CHECK(light(0.9F) == doctest::Approx(fine).epsilon(0.15));
  CHECK(light(4.0F) == doctest::Approx(fine).epsilon(0.1));
}

TEST_CASE("small balls are brighter on the side of the sun") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  scene.sun.intensity = 1.0F;
  scene.sun.direction = glm::vec3(1, 0.7F, 0.5F);
  InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0)));
  // The radius is 1.5 pixels, and the ball's centre is at a pixel's centre.
  ball.instances.size = 2 * 1.5F / (0.5F * 65 / std::tan(0.5F * 0.6981317F)) * 5;
  ball.material.color = glm::vec3(0.5F);
  const Picture p = drawn(scene, {{}, {ball.instances}}, {65, 65});
  CHECK(p.at(33, 32).y > p.at(31, 32).y + 10);
  CHECK(p.at(32, 31).y > p.at(32, 33).y + 10);
}

TEST_CASE("mirroring the light mirrors the shading of small balls") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  scene.sun.intensity = 1.0F;
  InstanceStage ball(std::vector<glm::vec3>(1, glm::vec3(0)));
  ball.instances.size = 2 * 1.5F / (0.5F * 65 / std::tan(0.5F * 0.6981317F)) * 5;
  ball.material.color = glm::vec3(0.5F);
  const auto lit = [&](float x, float y) {
    scene.sun.direction = glm::vec3(x, y, 0.5F);
    return drawn(scene, {{}, {ball.instances}}, {65, 65}, 1);  // with one sample per pixel, the sample is
                                                               // at the pixel's centre
  };
  const Picture plain = lit(1, 0.7F);
  const Picture other = lit(-1, 0.7F);
  const Picture below = lit(1, -0.7F);
  const Picture turned = lit(0.7F, 1);
  int maximum = 0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      const int here = plain.brightness(32 + x, 32 + y);
      maximum = std::max(maximum, here);
      // The tolerance covers dithering, whose offset differs between pixels.
      CHECK(std::abs(here - other.brightness(32 - x, 32 + y)) <= 3);
      CHECK(std::abs(here - below.brightness(32 + x, 32 - y)) <= 3);
      CHECK(std::abs(here - turned.brightness(32 - y, 32 - x)) <= 3);
    }
  CHECK(maximum > 150);
}

TEST_CASE("mesh instances align their z axis with the velocity") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  // Mesh of a needle along the z axis.
  const auto file = temporaryMesh("simreel_needle.obj",
                                  "v 0.1 0 -1\nv -0.1 0.1 -1\nv -0.1 -0.1 -1\nv 0 0 1\n"
                                  "f 1 2 3\nf 2 1 4\nf 3 2 4\nf 1 3 4\n");
  const auto extent = [&](glm::vec3 velocity, bool along) {
    InstanceStage needle({{0, 0, 0, 1}}, {glm::vec4(velocity, 0)});
    needle.instances.shape = Shape::mesh;
    needle.instances.mesh = file;
    needle.instances.size = 0.5F;
    if (along) needle.instances.turning = sim::Instances::Turning::velocity;
    const Picture p = drawn(scene, {{}, {needle.instances}}, {65, 65}, 1);
    glm::ivec2 low(65);
    glm::ivec2 high(-1);
    for (int y = 0; y < 65; ++y)
      for (int x = 0; x < 65; ++x)
        if (p.brightness(x, y) > 15) {
          low = glm::min(low, glm::ivec2(x, y));
          high = glm::max(high, glm::ivec2(x, y));
        }
    return high - low + 1;
  };
  // The scale is 17.9 pixels per metre and the needle is 1 m long.
  CHECK(extent({3, 0, 0}, true).x >= 14);
  CHECK(extent({3, 0, 0}, true).y <= 4);
  CHECK(extent({0, -2, 0}, true).y >= 14);
  CHECK(extent({0, -2, 0}, true).x <= 4);
  CHECK(extent({0, 0, 0}, true).x <= 4);
  CHECK(extent({3, 0, 0}, false).x <= 4);
  std::filesystem::remove(file);
}

TEST_CASE(
    "bloom: zero strength has no effect; otherwise it is symmetric, falls off, and grows with strength") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  InstanceStage glow(std::vector<glm::vec3>(1, glm::vec3(0)));
  glow.instances.additive = true;
  glow.instances.size = 0.4F;
  glow.instances.brightness = 20;
  for (const int samples : {1, 4}) {
    const auto shown = [&](float strength, float threshold) {
      scene.render.bloom.strength = strength;
      scene.render.bloom.threshold = threshold;
      scene.render.bloom.radius = 0.25F;
      return drawn(scene, {{}, {glow.instances}}, {131, 131}, samples);
    };
    const Picture off = shown(0, 1);
    CHECK(off.brightness(65 + 20, 65) < 6);
    const Picture on = shown(1, 1);
    for (const int away : {14, 20, 30}) {
      CAPTURE(away);
      const int right = on.brightness(65 + away, 65);
      // The tolerance is needed because half-size texels are not symmetric about the centre of a picture of
      // odd size.
      for (const int other :
           {on.brightness(65 - away, 65), on.brightness(65, 65 + away), on.brightness(65, 65 - away)})
        CHECK(std::abs(other - right) <= 12 + right / 12);
    }
    CHECK(on.brightness(65 + 14, 65) > 30);
    CHECK(on.brightness(65 + 14, 65) > on.brightness(65 + 24, 65) + 5);
    CHECK(on.brightness(65 + 24, 65) > on.brightness(65 + 50, 65) + 2);
    CHECK(shown(2, 1).brightness(65 + 14, 65) > on.brightness(65 + 14, 65) + 10);
    CHECK(shown(1, 30).bytes == shown(2, 30).bytes);  // none of the pixels exceeds the threshold
  }
}

TEST_CASE("light beyond the range of half floats stays white, with and without bloom") {
  testContext();
  scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  InstanceStage glow(std::vector<glm::vec3>(9, glm::vec3(0)));
  glow.instances.additive = true;
  glow.instances.size = 1;
  glow.instances.brightness = 6e4F;
  for (const float strength : {0.0F, 0.5F})
    for (const int samples : {1, 4}) {
      scene.render.bloom.strength = strength;
      CHECK(drawn(scene, {{}, {glow.instances}}, {33, 33}, samples).brightness(16, 16) > 740);
    }
}
