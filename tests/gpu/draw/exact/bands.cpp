#include "base/file.hpp"
#include "draw/exact/pass_list.hpp"
#include "golden/trace/passes.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <cmath>
#include <deque>
#include <filesystem>

#include <doctest/doctest.h>

using namespace simreel;  // NOLINT

namespace {

using Kind = sim::Instances::Shape;

/// Scene with all features: a sheet that extends beyond the picture, balls, mesh copies and glows, a
/// reflective ground, a sun and a lamp with shadows, and bloom.
struct BandStage {
  explicit BandStage(scene::Quality quality)
      : sheet({{-9, 0.3F, -4}, {9, 0.4F, -4}, {-9, 1.1F, 3}, {9, 0.2F, 3}}, {0, 2, 1, 1, 2, 3},
              std::vector<glm::vec3>(4, glm::vec3(0, 1, 0))) {
    sheet.surface.doubleSided = true;
    scene.render.quality = quality;
    writeFileAtomically(dart,
                        "v 0 0 0.6\nv 0.34 0.03 -0.4\nv -0.34 0.03 -0.4\nv 0 -0.14 -0.4\n"
                        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    scene.camera.position = glm::vec3(0.3F, 1.6F, 4);
    scene.camera.target = glm::vec3(0, 0.5F, 0);
    scene.camera.roll = 5.0F;
    scene.ground.emplace();
    scene.ground->height = 0;
    scene.ground->roughness = 0.3F;
    scene.render.bloom.strength = 0.3F;
    scene::Light lamp;
    lamp.position = glm::vec3(1, 2.5F, 1);
    lamp.shadow = true;
    scene.lights.push_back(lamp);
    for (const Kind kind : {Kind::sprite, Kind::sphere, Kind::mesh})
      for (const bool additive : {false, true}) {
        std::vector<glm::vec4> places;
        for (int i = 0; i < 37; ++i) {
          const auto at = [&](float step) { return 2.2F * std::sin(step * static_cast<float>(i + 1)); };
          places.emplace_back(at(1.3F), 1.1F + 0.5F * at(2.1F), at(0.7F), 1);
        }
        groups.emplace_back(places,
                            std::vector<glm::vec4>(places.size(), glm::vec4(0.3F, 0.1F, 0.2F, 0.5F)));
        InstanceStage& group = groups.back();
        group.instances.shape = kind;
        group.instances.mesh = dart;
        group.instances.additive = additive;
        group.instances.size = additive ? 0.7F : 0.3F;
      }
    drawables.surfaces = {sheet.surface};
    for (const InstanceStage& group : groups) drawables.instances.push_back(group.instances);
  }

  std::filesystem::path dart = temporaryFile("band_dart.obj");
  scene::Scene scene;
  TriangleStage sheet;
  std::deque<InstanceStage> groups;
  sim::Drawables drawables;
};

}  // namespace

TEST_CASE("exact: pictures drawn in bands have the bytes of those drawn at once") {
  testContext();
  const glm::ivec2 size(75, 61);
  for (const auto& [quality, samples] : {std::pair(scene::Quality::draft, 1),
                                         {scene::Quality::draft, 4},
                                         {scene::Quality::standard, 1},
                                         {scene::Quality::standard, 4}}) {
    CAPTURE(samples);
    CAPTURE(quality == scene::Quality::standard);
    const BandStage stage(quality);
    // Occluders in other bands must darken a band, too.
    const auto banded = [&](int rows) {
      return drawn(
          stage.scene, stage.drawables, size, samples,
          {.rasterizer = {}, .visibilityBytes = static_cast<std::size_t>(8 * samples * size.x * rows)});
    };
    const Picture whole = banded(size.y);
    for (const int rows : {1, 17, 40, 60}) {  // gives bands of 8, 16, 40 and 56 rows
      CAPTURE(rows);
      CHECK(banded(rows).bytes == whole.bytes);
    }
    const Picture empty = drawn(stage.scene, {}, size, samples);
    CHECK(compare(whole, empty).far > 500);
  }
}

TEST_CASE("exact: passes of pictures drawn in bands are those of pictures drawn at once") {
  testContext();
  const BandStage stage(scene::Quality::standard);
  const glm::ivec2 size(75, 61);
  const auto passes = [&](int rows) {
    draw::Renderer renderer(stage.scene, size, 4,
                            {.rasterizer = scene::Rasterizer::exact,
                             .visibilityBytes = static_cast<std::size_t>(8 * 4 * size.x * rows)});
    draw::PassPicture kept;
    renderer.keepPasses(&kept);
    renderer.draw(0, stage.drawables);
    const auto first = golden::hashesOf(kept);
    renderer.draw(0, stage.drawables);  // the pass outputs of the second picture replace those of the first
    CHECK(golden::hashesOf(kept) == first);
    for (const draw::PassArray& array : kept.arrays) {
      if (array.pass == "shadow" || array.pass == "bloom") continue;
      CHECK(array.width == size.x);
      CHECK(array.height == size.y);
    }
    CHECK(kept.things.size() == 4);
    return first;
  };
  const auto whole = passes(size.y);
  CHECK(whole.size() == draw::passNames().size());
  CHECK(passes(17) == whole);
  CHECK(passes(56) == whole);
}

TEST_CASE("exact: a picture's stages are those of the list of passes, in its order, whole or in bands") {
  testContext();
  BandStage stage(scene::Quality::standard);
  stage.scene.ground->roughness = 0.05F;  // the smooth ground reflects the scene
  const glm::ivec2 size(75, 61);
  const auto stages = [&](int rows) {
    draw::Renderer renderer(stage.scene, size, 1,
                            {.rasterizer = scene::Rasterizer::exact,
                             .visibilityBytes = static_cast<std::size_t>(8 * size.x * rows)});
    std::string names;
    renderer.draw(0, stage.drawables, [&](const char* name) { names += std::string(name) + "; "; });
    return names;
  };
  CHECK(stages(size.y) ==
        "shadow; visibility; occlusion; surfaces; reflections; instances; bloom; tone map; ");
  // There are two bands. After each pass that needs the whole view, the visibility of each band is computed
  // again.
  CHECK(stages(40) ==
        "shadow; visibility; occlusion; visibility; occlusion; "
        "visibility; surfaces; visibility; surfaces; reflections; "
        "visibility; surfaces; reflections; visibility; surfaces; reflections; "
        "visibility; surfaces; reflections; visibility; surfaces; reflections; "
        "visibility; surfaces; instances; visibility; surfaces; instances; "
        "bloom; tone map; ");
}
