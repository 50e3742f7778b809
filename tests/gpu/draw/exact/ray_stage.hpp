#pragma once
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <doctest/doctest.h>

/// Light of a picture's pixels, before the film.
struct RayPicture {
  glm::ivec2 size{0};
  std::vector<float> light;
  [[nodiscard]] glm::dvec3 at(int x, int y) const {
    const std::size_t i =
        4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x));
    return {light[i], light[i + 1], light[i + 2]};
  }
  [[nodiscard]] glm::dvec3 mean(glm::ivec2 from, glm::ivec2 to) const {
    glm::dvec3 sum(0);
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) sum += at(x, y);
    return sum / static_cast<double>((to.x - from.x) * (to.y - from.y));
  }
};

inline RayPicture rayPicture(const simreel::scene::Scene& scene, const simreel::sim::Drawables& drawables,
                             glm::ivec2 size, int samples = 1) {
  using namespace simreel;  // NOLINT
  draw::Renderer renderer(scene, size, samples, {.rasterizer = scene::Rasterizer::exact});
  draw::PassPicture kept;
  renderer.keepPasses(&kept);
  renderer.draw(0, drawables);
  testContext().check();
  RayPicture picture;
  picture.size = size;
  for (const draw::PassArray& array : kept.arrays)
    if (array.pass == "light" && array.part.empty())
      for (const std::uint32_t word : array.words) picture.light.push_back(std::bit_cast<float>(word));
  REQUIRE(picture.light.size() == 4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  return picture;
}

/// Returns a scene under a uniform sky, without a sun.
inline simreel::scene::Scene furnace(int raySamples) {
  using namespace simreel;  // NOLINT
  scene::Scene scene;
  scene.render.rasterizer = scene::Rasterizer::exact;
  scene.render.quality = scene::Quality::high;
  scene.render.raySamples = raySamples;
  scene.sun.intensity = 0.0F;
  scene.sky.zenith = scene.sky.horizon = scene.sky.ground = glm::vec3(1);
  scene.camera.position = glm::vec3(0, 0, 4);
  scene.camera.target = glm::vec3(0);
  return scene;
}

/// Places a camera at a height. The camera looks straight down at the origin.
inline void lookDown(simreel::scene::Scene& scene, float height, float angle) {
  scene.camera.position = glm::vec3(0, height, 1e-3F);
  scene.camera.target = glm::vec3(0);
  scene.camera.fieldOfView = angle;
}

inline void setGround(simreel::scene::Scene& scene, float color) {
  scene.ground.emplace();
  scene.ground->height = 0;
  scene.ground->color = glm::vec3(color);
  scene.ground->roughness = 1;
}
