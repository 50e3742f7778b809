// Tests haze in pictures by comparison with the Beer-Lambert law and between qualities.
#include "draw/exact/exact_view.hpp"
#include "gpu/draw/exact/ray_stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

constexpr glm::ivec2 hazyPicture(24, 16);

/// Returns a scene without light, whose haze has the colour 1.
scene::Scene darkInHaze(scene::Quality quality, float distance) {
  scene::Scene scene = furnace(16);
  scene.render.quality = quality;
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(0);
  scene.camera.position = glm::vec3(0, 3, 8);
  scene.camera.target = glm::vec3(0, 2.5F, 0);
  scene.camera.far = 1000;
  scene.haze.emplace();
  scene.haze->distance = distance;
  scene.haze->color = glm::vec3(1);
  return scene;
}

constexpr scene::Quality qualities[] = {scene::Quality::draft, scene::Quality::standard,
                                        scene::Quality::high};

}  // namespace

TEST_CASE("haze: black ground shows 1 - exp(-optical depth) of the haze's colour at every distance") {
  testContext();
  for (const scene::Quality quality : qualities)
    for (const double height : {0.0, 1.5}) {
      scene::Scene scene = darkInHaze(quality, 20);
      setGround(scene, 0);
      scene.ground->fadeStart = 900;
      scene.ground->fadeEnd = 901;
      if (height > 0) scene.haze->height = height;
      const RayPicture picture = rayPicture(scene, {}, hazyPicture);
      const shader::ExactView view =
          draw::exactView(draw::viewAt(scene.camera, 0, hazyPicture, {}), scene.camera, hazyPicture);
      int places = 0;
      double worst = 0;
      for (int y = 0; y < hazyPicture.y; ++y) {
        const glm::dvec3 ray =
            glm::dvec3(draw::placeOf(view, {12.5F, static_cast<float>(y) + 0.5F}, 1)) - glm::dvec3(0, 3, 8);
        if (ray.y > -0.01) continue;
        const double way = -3 / ray.y * glm::length(ray);
        const double mean = height > 0 ? (1 - std::exp(-3 / height)) / (3 / height) : 1;
        worst = std::max(worst, std::abs(picture.at(12, y).x - (1 - std::exp(-way / 20 * mean))));
        ++places;
      }
      CAPTURE(static_cast<int>(quality));
      CAPTURE(height);
      CHECK(places > 5);
      CHECK(worst < 1e-5);
    }
}

TEST_CASE("haze: surfaces, balls and the ground look the same in all qualities") {
  testContext();
  const auto drawnAs = [](scene::Quality quality) {
    scene::Scene scene = furnace(256);
    scene.render.quality = quality;
    scene.camera.position = glm::vec3(0, 3, 8);
    scene.sun.intensity = 2.0F;
    scene.sun.shadow = false;
    scene.sky.ambient = 0.0F;
    scene.sky.zenith = glm::vec3(0.1F, 0.2F, 0.5F);
    scene.sky.horizon = glm::vec3(0.7F, 0.6F, 0.5F);
    scene.render.occlusionRadius = 1e-3;
    setGround(scene, 0.1F);
    scene.haze.emplace();
    scene.haze->distance = 12.0F;
    scene.haze->height = 6;
    InstanceStage balls({{-2, 2, 0}, {2, 1.5F, -6}});
    balls.instances.shape = sim::Instances::Shape::sphere;
    balls.instances.size = 2;
    balls.material.roughness = 1;
    GridStage sheet({5, 5}, {-0.8F, 2.5F, -3}, {1.6F, 0, 0}, {0, -1.6F, 0});
    sheet.material.roughness = 1;
    return rayPicture(scene, {.surfaces = {sheet.surface}, .instances = {balls.instances}}, {48, 32});
  };
  const RayPicture draft = drawnAs(scene::Quality::draft);
  const RayPicture standard = drawnAs(scene::Quality::standard);
  const RayPicture high = drawnAs(scene::Quality::high);
  double drafted = 0;
  double traced = 0;
  double brightness = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 48; ++x) {
      drafted += glm::distance(draft.at(x, y), standard.at(x, y));
      traced += glm::distance(high.at(x, y), standard.at(x, y));
      brightness += glm::length(standard.at(x, y));
    }
  CAPTURE(drafted / brightness);
  CAPTURE(traced / brightness);
  CHECK(drafted < 0.005 * brightness);
  CHECK(traced < 0.03 * brightness);
}

TEST_CASE("haze: a mirror shows the ground through the haze of both ways, in standard and in high") {
  testContext();
  for (const scene::Quality quality : {scene::Quality::standard, scene::Quality::high}) {
    scene::Scene scene = darkInHaze(quality, 15);
    setGround(scene, 0);
    scene.ground->fadeStart = 900;
    scene.ground->fadeEnd = 901;
    scene.camera.position = glm::vec3(0, 3, 8);
    scene.camera.target = glm::vec3(0, 2, 0);
    GridStage mirror({2, 2}, {-9, 9, 0}, {18, 0, 0}, {0, -9, 0});
    mirror.material.color = glm::vec3(1);
    mirror.material.metallic = 1;
    mirror.material.roughness = 0.02F;
    const RayPicture picture = rayPicture(scene, {.surfaces = {mirror.surface}}, {25, 17});
    const shader::ExactView view =
        draw::exactView(draw::viewAt(scene.camera, 0, {25, 17}, {}), scene.camera, {25, 17});
    // The ray that the mirror (z = 0) reflects to the eye descends further to the ground.
    const glm::dvec3 ray =
        glm::normalize(glm::dvec3(draw::placeOf(view, {12.5F, 8.5F}, 1)) - glm::dvec3(0, 3, 8));
    const double both = -3 / ray.y;
    CAPTURE(static_cast<int>(quality));
    // The mirror reflects 0.96 to 1 of the light.
    const double wanted = 1 - std::exp(-both / 15);
    CHECK(picture.at(12, 8).x == doctest::Approx(wanted).epsilon(0.03));
  }
}

TEST_CASE(
    "haze: a mirror shows an object dimmed by exp(-optical depth) of both ways, in standard and in high") {
  testContext();
  constexpr glm::ivec2 size(17, 65);
  const glm::dvec3 eye(0, 4, 6);
  for (const scene::Quality quality : {scene::Quality::standard, scene::Quality::high}) {
    scene::Scene scene = darkInHaze(quality, 5);
    scene.haze->color = glm::vec3(0);
    scene.camera.position = glm::vec3(eye);
    scene.camera.target = glm::vec3(0, 1, -1);
    scene.camera.fieldOfView = 60;
    GridStage mirror({2, 2}, {-9, 0, 6}, {18, 0, 0}, {0, 0, -8});
    mirror.material.color = glm::vec3(1);
    mirror.material.metallic = 1;
    mirror.material.roughness = 0.02F;
    GridStage screen({2, 2}, {-9, 4, -2}, {18, 0, 0}, {0, -3, 0});
    screen.material.color = glm::vec3(0);
    screen.material.finish.emission = glm::vec3(1);
    const shader::ExactView view =
        draw::exactView(draw::viewAt(scene.camera, 0, size, {}), scene.camera, size);
    const auto drawn = [&] {
      return rayPicture(scene, {.surfaces = {mirror.surface, screen.surface}}, size);
    };
    const RayPicture hazy = drawn();
    scene.haze->distance = 1e6F;
    const RayPicture clear = drawn();
    CAPTURE(static_cast<int>(quality));
    int places = 0;
    for (int y = 0; y < size.y; ++y) {
      const glm::dvec3 ray =
          glm::normalize(glm::dvec3(draw::placeOf(view, {8.5F, static_cast<float>(y) + 0.5F}, 1)) - eye);
      const double way = -8 / ray.z;  // to the plane of the screen; the mirror folds the ray
      const double height = -(eye.y + way * ray.y);
      if (ray.z > -0.1 || height < 1.6 || height > 3.4) continue;
      const double kept = hazy.at(8, y).x / clear.at(8, y).x;
      CHECK(kept == doctest::Approx(std::exp(-way / 5)).epsilon(0.02));
      ++places;
    }
    CHECK(places > 2);
  }
}

TEST_CASE("haze: glows are dimmed, and the haze adds nothing to them") {
  testContext();
  const auto brightest = [](bool hazy) {
    scene::Scene scene = darkInHaze(scene::Quality::draft, 10);
    if (!hazy) scene.haze.reset();
    InstanceStage glow({{0, 2.5F, 0}});
    glow.instances.additive = true;
    glow.instances.size = 2;
    draw::Renderer renderer(scene, hazyPicture, 1, {.rasterizer = scene::Rasterizer::exact});
    draw::PassPicture kept;
    renderer.keepPasses(&kept);
    renderer.draw(0, {.instances = {glow.instances}});
    testContext().check();
    float light = 0;
    for (const draw::PassArray& array : kept.arrays)
      if (array.pass == "glow" && array.part == "glows")
        for (const std::uint32_t word : array.words)
          if (const float value = std::bit_cast<float>(word); value > light) light = value;
    return static_cast<double>(light);
  };
  const double plain = brightest(false);
  CHECK(plain > 0);
  const double way = glm::distance(glm::dvec3(0, 3, 8), glm::dvec3(0, 2.5, 0));
  CHECK(brightest(true) == doctest::Approx(plain * std::exp(-way / 10)).epsilon(1e-4));
}

TEST_CASE("haze: a blended sheet adds the haze before it in proportion to its opacity") {
  testContext();
  for (const scene::Quality quality : qualities) {
    scene::Scene scene = darkInHaze(quality, 10);
    GridStage sheet({2, 2}, {-9, 9, 0}, {18, 0, 0}, {0, -18, 0});
    sheet.material.color = glm::vec3(0);
    sheet.material.finish.alpha = scene::Alpha::blend;
    sheet.material.finish.opacity = 0.25F;
    sheet.material.roughness = 1;
    const double way = glm::distance(glm::dvec3(0, 3, 8), glm::dvec3(0, 2.5, 0));
    CAPTURE(static_cast<int>(quality));
    CHECK(rayPicture(scene, {.surfaces = {sheet.surface}}, {25, 17}).at(12, 8).x ==
          doctest::Approx(0.25 * (1 - std::exp(-way / 10))).epsilon(1e-3));
  }
}

TEST_CASE("haze: a black wall behind a pane of glass looks the same in all qualities") {
  testContext();
  double seen[3] = {0, 0, 0};
  double bare = 0;
  for (int i = 0; i < 4; ++i) {
    scene::Scene scene = darkInHaze(qualities[i % 3], 10);
    scene.render.raySamples = 256;
    GridStage wall({2, 2}, {-30, 30, -6}, {60, 0, 0}, {0, -60, 0});
    GridStage pane({2, 2}, {-9, 9, 0}, {18, 0, 0}, {0, -18, 0});
    wall.material.color = glm::vec3(0);
    pane.material.color = glm::vec3(1);
    pane.material.roughness = 0;
    pane.material.finish.transmission = 1;
    pane.material.finish.thin = true;
    sim::Drawables drawables{.surfaces = {wall.surface}};
    if (i < 3) drawables.surfaces.push_back(pane.surface);
    (i < 3 ? seen[i] : bare) = rayPicture(scene, drawables, {25, 17}).at(12, 8).x;
  }
  // The pane reflects a dark sky, so less of the haze behind it is seen.
  CHECK(seen[0] < 0.99 * bare);
  CHECK(seen[0] > 0.85 * bare);
  CHECK(seen[1] == doctest::Approx(seen[0]).epsilon(1e-5));
  CHECK(seen[2] == doctest::Approx(seen[0]).epsilon(0.02));
}
