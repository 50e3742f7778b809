// Tests surfaces of glass in pictures without path tracing.
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <bit>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace exact_glass {

/// Returns the normals of a slab: four corners towards +z, then four towards -z.
std::vector<glm::vec3> slabNormals() {
  std::vector<glm::vec3> normals(8, glm::vec3(0, 0, 1));
  for (std::size_t i = 4; i < normals.size(); ++i) normals[i] = glm::vec3(0, 0, -1);
  return normals;
}

/// A slab of glass in front of a bright square.
struct GlassStage {
  explicit GlassStage(scene::Quality quality)
      : slab({{-1, 1, 1.2F},
              {1, 1, 1.2F},
              {-1, -1, 1.2F},
              {1, -1, 1.2F},
              {-1, 1, 1},
              {1, 1, 1},
              {-1, -1, 1},
              {1, -1, 1}},
             {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6}, slabNormals()),
        square({{-2, 2, 0}, {2, 2, 0}, {-2, -2, 0}, {2, -2, 0}}, {0, 2, 1, 1, 2, 3},
               std::vector<glm::vec3>(4, glm::vec3(0, 0, 1))) {
    scene.render.quality = quality;
    scene.render.rasterizer = scene::Rasterizer::exact;
    slab.material.roughness = 0;
    slab.material.color = glm::vec3(1, 0.5F, 0.25F);
    slab.material.finish.transmission = 1;
    slab.material.finish.attenuation = glm::vec3(0.5F, 1, 0.8F);
    slab.material.finish.attenuationDistance = 0.2F;
    square.material.color = glm::vec3(0);
    square.material.roughness = 1;
    square.material.finish.emission = glm::vec3(0.6F, 0.7F, 0.8F);
    drawables.surfaces = {square.surface, slab.surface};
  }

  scene::Scene scene = darkScene();
  TriangleStage slab, square;
  sim::Drawables drawables;
};

/// Returns the light of a pixel, before the film.
glm::vec4 lightAt(GlassStage& stage, glm::ivec2 size, glm::ivec2 at) {
  draw::PassPicture kept;
  draw::Renderer renderer(stage.scene, size, 4, {.rasterizer = scene::Rasterizer::exact});
  renderer.keepPasses(&kept);
  renderer.draw(0, stage.drawables);
  for (const draw::PassArray& array : kept.arrays) {
    if (array.pass != "light") continue;
    const auto first = static_cast<std::size_t>(4 * (at.y * size.x + at.x));
    glm::vec4 light(0);
    for (int i = 0; i < 4; ++i)
      light[i] = std::bit_cast<float>(array.words.at(first + static_cast<std::size_t>(i)));
    return light;
  }
  FAIL("there is no light");
  return {};
}

}  // namespace exact_glass

TEST_CASE("exact: glass shows what is behind it, less what it reflects and absorbs") {
  testContext();
  const glm::ivec2 size(64, 64);
  for (const auto quality : {scene::Quality::draft, scene::Quality::standard}) {
    CAPTURE(static_cast<int>(quality));
    exact_glass::GlassStage stage(quality);
    stage.scene.sun.intensity = 0.0F;
    const glm::vec4 light = exact_glass::lightAt(stage, size, {32, 32});
    // Each of the two surfaces reflects 4 %. The slab is one attenuation distance thick.
    const glm::vec3 wanted =
        0.96F * 0.96F * glm::vec3(1, 0.5F, 0.25F) * glm::vec3(0.5F, 1, 0.8F) * glm::vec3(0.6F, 0.7F, 0.8F);
    for (int i = 0; i < 3; ++i) CHECK(light[i] == doctest::Approx(wanted[i]).epsilon(0.005));
    CHECK(light.a == doctest::Approx(1));
  }
}

TEST_CASE("exact: glass is the same however a picture is found") {
  testContext();
  const glm::ivec2 size(91, 67);
  for (const auto quality : {scene::Quality::draft, scene::Quality::standard}) {
    exact_glass::GlassStage stage(quality);
    stage.scene.camera.position = glm::vec3(2, 1, 4);
    stage.scene.ground.emplace();
    stage.scene.ground->height = -1;
    const auto banded = [&](int rows) {
      return drawn(stage.scene, stage.drawables, size, 4,
                   {.rasterizer = {}, .visibilityBytes = static_cast<std::size_t>(8 * 4 * size.x * rows)});
    };
    const Picture whole = banded(size.y);
    CHECK(banded(24).bytes == whole.bytes);
    for (const char* word : LayoutForced::words()) {
      const LayoutForced asked(word);
      CHECK(banded(size.y).bytes == whole.bytes);
    }
    stage.drawables.surfaces = {stage.slab.surface, stage.square.surface};
    CHECK(banded(size.y).bytes == whole.bytes);
  }
}
