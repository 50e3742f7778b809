#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact_stage.hpp"
#include "reference/picture_twin.hpp"

#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Waves over the ground, before the camera and beneath it, some of their triangles seen from behind.
PictureTwinScene wavySheet(int side) {
  PictureTwinScene scene;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto at = [&](int i) {
        return 6.0F * (static_cast<float>(i) / static_cast<float>(side - 1) - 0.5F);
      };
      const float u = at(x);
      const float v = at(y);
      scene.places.emplace_back(u, 0.4F * std::sin(2.1F * u + v), v);
      scene.normals.push_back(
          glm::normalize(glm::vec3(-0.84F * std::cos(2.1F * u + v), 1, -0.4F * std::cos(2.1F * u + v))));
    }
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const auto a = static_cast<unsigned>(y * side + x);
      const auto below = a + static_cast<unsigned>(side);
      scene.indices.insert(scene.indices.end(), {a, below, a + 1, a + 1, below, below + 1});
    }
  return scene;
}

scene::Scene exactScene(int samples) {
  scene::Scene scene;
  scene.render.rasterizer = scene::Rasterizer::exact;
  scene.render.samples = samples;
  scene.render.vignette = 0.3F;
  scene.camera.position = glm::vec3(0.6F, 1.7F, 4.1F);
  scene.camera.roll = 7.0F;
  scene.sun.shadow = false;
  scene.hasGround = true;
  scene.ground.height = -0.2F;
  scene.ground.roughness = 0.4F;  // it mirrors, as the twin does
  return scene;
}

}  // namespace

TEST_CASE("exact: whole pictures are the twin's in every byte") {
  const glm::ivec2 size(91, 59);
  for (const int samples : {1, 4, 16}) {
    for (const float metallic : {0.0F, 0.7F}) {
      const scene::Scene scene = exactScene(samples);
      PictureTwinScene twin = wavySheet(23);
      twin.samples = samples;
      twin.doubleSided = metallic > 0;
      twin.metallic = metallic;
      twin.roughness = 0.35F;
      twin.color = {0.7F, 0.4F, 0.2F};
      twin.frame = draw::frameValues(scene, size, 0, {});
      twin.view = draw::exactView(draw::viewAt(scene.camera, 0, size, {}), scene.camera, size);
      TriangleStage stage(twin.places, twin.indices, twin.normals);
      stage.surface.doubleSided = twin.doubleSided;
      stage.material.color = twin.color;
      stage.material.roughness = twin.roughness;
      stage.material.metallic = twin.metallic;
      const Picture picture = drawn(scene, {.surfaces = {stage.surface}}, size, samples);
      const std::vector<std::uint8_t> wanted = pictureTwin(twin);
      REQUIRE(picture.bytes.size() == wanted.size());
      int others = 0;
      for (std::size_t i = 0; i < wanted.size(); ++i) others += picture.bytes[i] != wanted[i] ? 1 : 0;
      CAPTURE(samples);
      CHECK(others == 0);
    }
  }
}
