#include "base/file.hpp"
#include "draw/surface/mip_levels.hpp"
#include "frame/image.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "reference/picture_twin.hpp"

#include <filesystem>
#include <random>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Returns a wavy sheet above the ground, in front of and below the camera. The back sides of some
/// triangles are visible.
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
  scene.ground.emplace();
  scene.ground->height = -0.2F;
  scene.ground->roughness = 0.4F;  // The ground is reflective, because the CPU version assumes that.
  return scene;
}

/// Sets frame values and view from the scene.
void see(PictureTwinScene& twin, const scene::Scene& scene, glm::ivec2 size, int samples) {
  twin.samples = samples;
  twin.frame = draw::frameValues(scene, size, 0, {});
  twin.view = draw::exactView(draw::viewAt(scene.camera, 0, size, {}), scene.camera, size);
}

/// Returns the number of bytes in which the kernels' picture differs from the CPU version's picture.
int othersThanTwin(const scene::Scene& scene, const PictureTwinScene& twin, TriangleStage& stage,
                   glm::ivec2 size) {
  stage.surface.doubleSided = twin.doubleSided;
  stage.material.color = twin.color;
  stage.material.roughness = twin.roughness;
  stage.material.metallic = twin.metallic;
  const Picture picture = drawn(scene, {.surfaces = {stage.surface}}, size, twin.samples);
  const std::vector<std::uint8_t> wanted = pictureTwin(twin);
  REQUIRE(picture.bytes.size() == wanted.size());
  int others = 0;
  for (std::size_t i = 0; i < wanted.size(); ++i) others += picture.bytes[i] != wanted[i] ? 1 : 0;
  return others;
}

/// Returns a picture with random colours and alpha 255.
frame::Image noisePicture(glm::ivec2 size) {
  frame::Image image{size.x, size.y, {}};
  std::mt19937 random(5);
  for (int i = 0; i < 4 * size.x * size.y; ++i)
    image.bytes.push_back(i % 4 == 3 ? 255 : static_cast<std::uint8_t>(random() >> 24U));
  return image;
}
std::vector<std::vector<glm::uvec3>> lightOf(const frame::Image& image) {
  std::vector<std::vector<glm::uvec3>> levels;
  const auto add = [&](std::span<const std::uint8_t> rgba) {
    std::vector<glm::uvec3> texels;
    for (std::size_t i = 0; i < rgba.size(); i += 4)
      texels.emplace_back(draw::linearOfSrgb(rgba[i]), draw::linearOfSrgb(rgba[i + 1]),
                          draw::linearOfSrgb(rgba[i + 2]));
    levels.push_back(std::move(texels));
  };
  add(image.bytes);
  for (const draw::MipLevel& level : draw::mipLevels({image.width, image.height}, image.bytes))
    add(level.rgba);
  return levels;
}

}  // namespace

TEST_CASE("exact: whole pictures are the twin's in every byte") {
  const glm::ivec2 size(91, 59);
  for (const int samples : {1, 4, 16}) {
    for (const float metallic : {0.0F, 0.7F}) {
      scene::Scene scene = exactScene(samples);
      if (metallic > 0) scene.render.exposure = 3.0F;  // evens the edges of highlights
      PictureTwinScene twin = wavySheet(23);
      see(twin, scene, size, samples);
      twin.doubleSided = metallic > 0;
      twin.metallic = metallic;
      twin.roughness = 0.35F;
      twin.color = {0.7F, 0.4F, 0.2F};
      TriangleStage stage(twin.places, twin.indices, twin.normals);
      CAPTURE(samples);
      CHECK(othersThanTwin(scene, twin, stage, size) == 0);
    }
  }
}

TEST_CASE("exact: pictures with haze are the twin's in every byte") {
  const glm::ivec2 size(91, 59);
  for (const double height : {0.0, 0.7}) {
    scene::Scene scene = exactScene(4);
    scene.haze.emplace();
    scene.haze->distance = 3.0F;
    scene.haze->start = 1.2F;
    if (height > 0) scene.haze->height = height;
    PictureTwinScene twin = wavySheet(23);
    see(twin, scene, size, 4);
    twin.roughness = 0.35F;
    TriangleStage stage(twin.places, twin.indices, twin.normals);
    CAPTURE(height);
    CHECK(othersThanTwin(scene, twin, stage, size) == 0);
  }
}

TEST_CASE("exact: edges of highlights are the same whether a pass or the film expands their light") {
  const glm::ivec2 size(91, 59);
  scene::Scene scene = exactScene(4);
  scene.render.exposure = 3.0F;
  scene.render.bloom.strength = 0.5F;
  const PictureTwinScene sheet = wavySheet(23);
  TriangleStage stage(sheet.places, sheet.indices, sheet.normals);
  stage.material.roughness = 0.35F;
  const auto bytes = [&](draw::PassPicture* kept) {
    draw::Renderer renderer(scene, size, 4, testOptions());
    draw::Readback readback(size);
    renderer.keepPasses(kept);
    renderer.draw(0, {.surfaces = {stage.surface}});
    readback.start(renderer.target(), 0);
    return readback.nextPicture(true).value().second;
  };
  draw::PassPicture kept;
  const auto late = bytes(nullptr);
  CHECK(late == bytes(&kept));
  CHECK(kept.arrays.size() > 0);
}

TEST_CASE("exact: triangles around the least area whose weights are their own are the twin's") {
  // At depths of 1e-14 m, the triangle areas (products of squared depths and pixels) are about 1e-25.
  const glm::ivec2 size(91, 59);
  scene::Scene scene = exactScene(4);
  scene.camera.position = glm::vec3(0);
  scene.camera.target = glm::vec3(0, 0, -1);
  scene.camera.near = 1e-14F;
  PictureTwinScene twin;
  see(twin, scene, size, 4);
  twin.doubleSided = true;
  int minimum = 0;
  for (int k = 0; k < 24; ++k) {
    const float area = (0.97F + 0.0025F * static_cast<float>(k)) * 1e-25F;
    minimum += area < 1e-25F ? 1 : 0;
    const float depth = std::sqrt(area / 154.0F);
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(13, 1), glm::vec2(2, 12)}) {
      const glm::vec2 at = corner + glm::vec2(15 * (k % 6) + 1, 14 * (k / 6) + 1);
      twin.places.push_back(
          depth * glm::vec3(twin.view.ray + at.x * twin.view.rayAcross + at.y * twin.view.rayDown));
      twin.normals.push_back(glm::normalize(glm::vec3(corner - 5.0F, 9)));
      twin.indices.push_back(static_cast<unsigned>(twin.indices.size()));
    }
  }
  CHECK(minimum == 12);
  TriangleStage stage(twin.places, twin.indices, twin.normals);
  CHECK(othersThanTwin(scene, twin, stage, size) == 0);
}

TEST_CASE("exact: textured pictures are the twin's in every byte, near, far and askew") {
  testContext();
  const glm::ivec2 size(91, 59);
  const auto file = std::filesystem::temp_directory_path() / "simreel_twin_texture.png";
  for (const glm::ivec2 texels : {glm::ivec2(37, 21), glm::ivec2(64, 1), glm::ivec2(1, 1)}) {
    const frame::Image image = noisePicture(texels);
    writeFileAtomically(file, frame::encodePng(image, {}));
    for (const glm::vec2 scale : {glm::vec2(0.3F, 0.2F), glm::vec2(3, 2.5F), glm::vec2(-40, 90)}) {
      const scene::Scene scene = exactScene(4);
      PictureTwinScene twin = wavySheet(23);
      see(twin, scene, size, 4);
      twin.doubleSided = true;
      twin.texture = {texels, lightOf(image), scale, {}};
      for (const glm::vec3& place : twin.places)
        twin.texture.uvs.emplace_back(0.3F * place.x - 1, 0.2F * place.z);
      TriangleStage stage(twin.places, twin.indices, twin.normals);
      stage.setUvs(twin.texture.uvs);
      stage.material.texture = file;
      stage.material.textureScale = glm::vec3(scale, 1);
      CAPTURE(texels.x);
      CAPTURE(scale.x);
      CHECK(othersThanTwin(scene, twin, stage, size) == 0);
    }
  }
  std::filesystem::remove(file);
}
