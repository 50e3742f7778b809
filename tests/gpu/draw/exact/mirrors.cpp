// Tests pictures with mirrors. Different methods of drawing must give the same picture, and reflections
// must agree with path tracing.
#include "draw/screen/renderer.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Reflective ground, reflective and matt balls and mesh copies, and a pane in front of all of them.
struct MirrorStage {
  explicit MirrorStage(scene::Quality quality)
      : wall({{-2, -0.1F, -1}, {2, -0.1F, -1.2F}, {-2, 1.6F, -1}, {2, 1.5F, -1.2F}}, {0, 1, 2, 2, 1, 3},
             std::vector<glm::vec3>(4, glm::vec3(0, 0, 1))),
        pane({{-0.4F, 0.05F, 1}, {0.5F, 0.05F, 1}, {-0.4F, 0.7F, 1}, {0.5F, 0.8F, 1.1F}},
             {0, 1, 2, 2, 1, 3}, std::vector<glm::vec3>(4, glm::vec3(0, 0, 1))),
        matt({{0.5F, 0.4F, 0.2F}, {-0.6F, 0.3F, -0.5F}}),
        chrome({{-0.1F, 0.35F, 0.1F}, {1.1F, 0.3F, -0.3F}}) {
    scene.render.rasterizer = scene::Rasterizer::exact;
    scene.render.quality = quality;
    scene.camera.position = glm::vec3(0.3F, 1, 3.6F);
    scene.camera.target = glm::vec3(0, 0.3F, 0);
    scene.ground.emplace();
    scene.ground->height = 0;
    scene.ground->color = glm::vec3(0);
    scene.ground->roughness = 0.03F;
    wall.material.color = glm::vec3(0.8F, 0.4F, 0.1F);
    wall.surface.doubleSided = true;
    pane.material.finish.alpha = scene::Alpha::blend;
    pane.material.finish.opacity = 0.4F;
    pane.surface.doubleSided = true;
    for (InstanceStage* balls : {&matt, &chrome}) {
      balls->instances.shape = sim::Instances::Shape::sphere;
      balls->instances.size = 0.6F;
    }
    chrome.material.metallic = 1;
    chrome.material.roughness = 0.05F;
    drawables.surfaces = {wall.surface};
    drawables.instances = {matt.instances, chrome.instances};
  }
  scene::Scene scene;
  TriangleStage wall, pane;
  InstanceStage matt, chrome;
  sim::Drawables drawables;
};

/// Returns the words of an array of a pass.
const std::vector<GLuint>& wordsOf(const draw::PassPicture& kept, const char* pass, const char* name) {
  for (const draw::PassArray& array : kept.arrays)
    if (array.pass == pass && array.part == name) return array.words;
  FAIL("there is no such pass");
  return kept.arrays.front().words;
}

/// Sums of the differences in light between path tracing and the qualities "draft" and "standard". The sums
/// cover the first sample of each pixel that shows one of certain ids.
struct FromRays {
  int places = 0;
  double draft = 0, standard = 0;
};

FromRays fromRays(const draw::PassPicture (&passes)[3], const std::function<bool(GLuint number)>& shows) {
  const auto& numbers = wordsOf(passes[0], "visibility", "numbers");
  FromRays off;
  for (std::size_t at = 0; at < numbers.size(); at += 4) {
    if (!shows(numbers[at])) continue;
    ++off.places;
    const auto sumOf = [&](const draw::PassPicture& kept) {
      double sum = 0;
      for (std::size_t i = 0; i < 3; ++i)
        sum += std::abs(static_cast<double>(std::bit_cast<float>(wordsOf(kept, "light", "")[at + i])) -
                        static_cast<double>(std::bit_cast<float>(wordsOf(passes[2], "light", "")[at + i])));
      return sum;
    };
    off.draft += sumOf(passes[0]);
    off.standard += sumOf(passes[1]);
  }
  return off;
}

/// Returns the sum, over neighbouring pixels that show only the ground, of the change of the difference
/// between "standard" and path tracing, divided by the same sum of the change of path-traced light.
/// Outlines with stairs, teeth or combs increase it; smooth differences of brightness do not.
double outlineError(const draw::PassPicture (&passes)[3], glm::ivec2 size) {
  const auto& numbers = wordsOf(passes[0], "visibility", "numbers");
  const auto shows = [&](std::size_t at) {
    return std::all_of(&numbers[at], &numbers[at] + 4, [](GLuint number) { return number == 0xfffffffeU; });
  };
  const auto lightAt = [](const draw::PassPicture& kept, std::size_t at) {
    return static_cast<double>(std::bit_cast<float>(wordsOf(kept, "light", "")[at]));
  };
  double error = 0;
  double detail = 0;
  const auto width = static_cast<std::size_t>(size.x);
  for (std::size_t pixel = 0; pixel + width < numbers.size() / 4; ++pixel)
    for (const std::size_t next : {pixel + 1, pixel + width}) {
      if (!shows(4 * pixel) || !shows(4 * next) || next % width == 0) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const double rays = lightAt(passes[2], 4 * next + i) - lightAt(passes[2], 4 * pixel + i);
        const double standard = lightAt(passes[1], 4 * next + i) - lightAt(passes[1], 4 * pixel + i);
        error += std::abs(standard - rays);
        detail += std::abs(rays);
      }
    }
  return error / detail;
}

}  // namespace

TEST_CASE("exact: mirrors show the same however a picture is found, and nothing without smooth materials") {
  testContext();
  MirrorStage stage(scene::Quality::standard);
  const glm::ivec2 size(91, 67);
  for (const bool layered : {false, true}) {
    CAPTURE(layered);
    if (layered) stage.drawables.surfaces.push_back(stage.pane.surface);
    const auto banded = [&](int rows) {
      return drawn(stage.scene, stage.drawables, size, 4,
                   {.rasterizer = {}, .visibilityBytes = static_cast<std::size_t>(8 * 4 * size.x * rows)});
    };
    const Picture whole = banded(size.y);
    for (const int rows : {1, 24, 64}) CHECK(banded(rows).bytes == whole.bytes);
    for (const char* word : {"yes", "no"}) {
      const JoiningForced joining(word);
      CHECK(banded(size.y).bytes == whole.bytes);
    }
    for (const char* word : LayoutForced::words()) {
      const LayoutForced asked(word);
      CHECK(banded(size.y).bytes == whole.bytes);
    }
  }
}

// Path tracing is the reference. The ground is black, so all its light is reflected light.
TEST_CASE("exact: mirrors show nearly what rays do, with outlines nearly as smooth") {
  testContext();
  const glm::ivec2 size(160, 100);
  scene::Projection projection = scene::Projection::perspective;
  const auto lightOf = [&](scene::Quality quality, draw::PassPicture& kept) {
    MirrorStage stage(quality);
    stage.scene.camera.projection = projection;
    stage.scene.camera.height = 2.4F;
    stage.scene.sun.shadow = false;
    stage.scene.sun.diameter = 0;
    stage.scene.render.raySamples = 32;
    draw::Renderer renderer(stage.scene, size, 4, {.rasterizer = scene::Rasterizer::exact});
    renderer.keepPasses(&kept);
    renderer.draw(0, stage.drawables);
  };
  for (const auto seen : {scene::Projection::perspective, scene::Projection::orthographic}) {
    projection = seen;
    CAPTURE(static_cast<int>(seen));
    draw::PassPicture passes[3];
    lightOf(scene::Quality::draft, passes[0]);
    lightOf(scene::Quality::standard, passes[1]);
    lightOf(scene::Quality::high, passes[2]);
    const FromRays off = fromRays(passes, [](GLuint number) { return number == 0xfffffffeU; });
    CAPTURE(off.draft);
    CAPTURE(off.standard);
    CHECK(off.places > 3000);
    CHECK(off.standard < 0.45 * off.draft);
    const double outlines = outlineError(passes, size);
    CAPTURE(outlines);
    // Reflections that are constant over 2x2 pixels, with light from behind objects at their edges, reach
    // 0.91 and 1.37.
    CHECK(outlines < (seen == scene::Projection::perspective ? 0.76 : 1.32));
  }
}

TEST_CASE("exact: what mirrors nothing has the light that it has beside matt things") {
  testContext();
  const glm::ivec2 size(301, 203);
  const auto lightOf = [&](float roughness, draw::PassPicture& kept) {
    MirrorStage stage(scene::Quality::standard);
    stage.scene.ground->roughness = roughness;
    draw::Renderer renderer(stage.scene, size, 4, {.rasterizer = scene::Rasterizer::exact});
    renderer.keepPasses(&kept);
    renderer.draw(0, stage.drawables);
  };
  draw::PassPicture smooth;
  draw::PassPicture matt;
  lightOf(0.03F, smooth);
  lightOf(0.5F, matt);
  const auto& numbers = wordsOf(smooth, "visibility", "numbers");
  const auto& light = wordsOf(smooth, "light", "");
  const auto& plain = wordsOf(matt, "light", "");
  int places = 0;
  for (std::size_t at = 0; at < numbers.size(); at += 4) {
    // Ids 0 and 1 are the triangles of the wall, and ids 2 and 3 are the matt balls.
    if (!std::all_of(&numbers[at], &numbers[at] + 4, [](GLuint number) { return number < 4; })) continue;
    ++places;
    for (std::size_t i = 0; i < 3; ++i) CHECK(light[at + i] == plain[at + i]);
  }
  CHECK(places > 1000);
}

// An upright mirror at an oblique angle with a ball next to it, and the ground in front of both.
TEST_CASE("exact: a mirror that stands on the ground shows nearly what rays do") {
  testContext();
  const glm::ivec2 size(160, 100);
  const auto lightOf = [&](scene::Quality quality, draw::PassPicture& kept) {
    MirrorStage stage(quality);
    const glm::vec3 facing = glm::normalize(glm::vec3(1, 0, 0.35F));
    TriangleStage mirror({{-0.9F, 0, 0.9F}, {-0.3F, 0, -0.8F}, {-0.9F, 1, 0.9F}, {-0.3F, 1, -0.8F}},
                         {0, 1, 2, 2, 1, 3}, std::vector<glm::vec3>(4, facing));
    mirror.surface.doubleSided = true;
    mirror.material.metallic = 1;
    mirror.material.roughness = 0.03F;
    mirror.material.color = glm::vec3(1);
    stage.scene.ground->color = glm::vec3(0.05F, 0.3F, 0.1F);
    stage.scene.ground->roughness = 1;
    stage.scene.sun.diameter = 0;
    stage.scene.render.raySamples = 32;
    stage.drawables.surfaces = {mirror.surface};
    stage.drawables.instances = {stage.matt.instances};
    draw::Renderer renderer(stage.scene, size, 4, {.rasterizer = scene::Rasterizer::exact});
    renderer.keepPasses(&kept);
    renderer.draw(0, stage.drawables);
  };
  draw::PassPicture passes[3];
  lightOf(scene::Quality::draft, passes[0]);
  lightOf(scene::Quality::standard, passes[1]);
  lightOf(scene::Quality::high, passes[2]);
  const FromRays off = fromRays(passes, [](GLuint number) { return number < 2; });
  CAPTURE(off.draft);
  CAPTURE(off.standard);
  CHECK(off.places > 1000);
  CHECK(off.standard < 0.15 * off.draft);
}
