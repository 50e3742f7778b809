#include "base/error.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "gpu/draw/draw_stage.hpp"
#include "gpu/draw/exact/stage.hpp"
#include "gpu/draw/instance_stage.hpp"
#include "gpu/draw/lamp_stage.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "source_folder.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

using namespace simreel;  // NOLINT

namespace {

/// Intersecting sheets and triangle meshes, so that pixels show many surfaces. The surfaces are rough,
/// reflective, translucent, single- and double-sided, and textured. A sun and a lamp with shadows light
/// them.
struct HeapStage {
  HeapStage() : sheet({9, 7}, {-1, 0.9F, 0.4F}, {2, 0.1F, -0.3F}, {0.1F, -1.6F, 0.2F}) {
    scene.camera.position = glm::vec3(0.4F, 0.7F, 3);
    scene.camera.target = glm::vec3(0);
    scene.ground.emplace();
    scene.ground->height = -0.8F;
    scene.lights.push_back(lampAt({0.8F, 0.9F, 1.1F}, 6, true));
    scene.lights.back().shadowSize = 128;
    for (int i = 0; i < 7; ++i) {
      Dice dice(31 + static_cast<unsigned>(i));
      std::vector<glm::vec3> places;
      std::vector<glm::vec3> directions;
      std::vector<glm::vec2> uvs;
      std::vector<unsigned> corners;
      for (unsigned k = 0; k < 3 * 40; ++k) {
        if (k % 3 == 0) middle = 0.7F * dice.cube();
        places.push_back(middle + 0.25F * dice.cube());
        directions.push_back(dice.cube());
        uvs.emplace_back(dice(), dice());
        corners.push_back(k);
      }
      heaps.emplace_back(places, corners, directions);
      TriangleStage& heap = heaps.back();
      heap.setUvs(uvs);
      heap.material.color = {0.2F + 0.1F * static_cast<float>(i), 0.9F,
                             0.8F - 0.1F * static_cast<float>(i)};
      heap.material.roughness = i % 3 == 0 ? 0.3F : 0.8F;
      heap.material.metallic = i == 4 ? 1.0F : 0.0F;
      heap.material.translucency = i == 2 ? 0.6F : 0.0F;
      if (i == 3) heap.material.texture = sourceFolder() + "/assets/textures/gingham.png";
      heap.surface.doubleSided = i % 2 == 0;
      heap.surface.still = i == 5 ? 0 : 900 + static_cast<unsigned>(i);
      drawables.surfaces.push_back(heap.surface);
      if (i == 1) drawables.surfaces.push_back(sheet.surface);
    }
    for (const TriangleStage& heap : heaps) {
      scene::Object object;
      object.material = heap.material;
      scene.objects.push_back(std::move(object));
    }
  }

  scene::Scene scene;
  GridStage sheet;
  std::deque<TriangleStage> heaps;
  glm::vec3 middle{0};
  sim::Drawables drawables;
};

struct Made {
  std::vector<std::vector<std::uint32_t>> words;
  std::size_t things = 0;
  bool operator==(const Made&) const = default;
};

/// Returns the results of several pictures. Between the pictures, surfaces move, disappear and appear.
std::vector<Made> madeOf(HeapStage& stage, const char* joins) {
  const JoiningForced asked(joins);
  draw::Renderer renderer(stage.scene, {93, 71}, 4,
                          {.rasterizer = scene::Rasterizer::exact, .visibilityBytes = 8 * 4 * 93 * 48});
  draw::PassPicture kept;
  renderer.keepPasses(&kept);
  std::vector<Made> made;
  for (int frame = 0; frame < 5; ++frame) {
    sim::Drawables drawables = stage.drawables;
    // The first picture has fewer surfaces, so that the buffers of the joined mesh must grow later.
    if (frame == 0) drawables.surfaces.resize(4);
    if (frame > 1) drawables.surfaces[2].model = glm::rotate(glm::mat4(1), 0.4F, glm::vec3(0.6F, 0.8F, 0));
    if (frame == 3) drawables.surfaces.erase(drawables.surfaces.begin());
    if (frame == 4) std::swap(drawables.surfaces[3], drawables.surfaces[6]);
    renderer.draw(0, drawables);
    testContext().check();
    Made& one = made.emplace_back();
    for (const draw::PassArray& array : kept.arrays) one.words.push_back(array.words);
    one.things = kept.things.size();
  }
  return made;
}

}  // namespace

TEST_CASE("exact: joined surfaces have the pictures of those that are drawn one by one") {
  testContext();
  for (const char* layout : LayoutForced::words()) {
    CAPTURE(layout);
    const LayoutForced asked(layout);
    HeapStage stage;
    const std::vector<Made> pixelDifference = madeOf(stage, "no");
    const std::vector<Made> joined = madeOf(stage, "yes");
    REQUIRE(pixelDifference.size() == joined.size());
    for (std::size_t i = 0; i < pixelDifference.size(); ++i) {
      CAPTURE(i);
      REQUIRE(pixelDifference[i].words.size() == joined[i].words.size());
      for (std::size_t k = 0; k < pixelDifference[i].words.size(); ++k)
        CHECK(pixelDifference[i].words[k] == joined[i].words[k]);
      CHECK(pixelDifference[i].things == joined[i].things);
    }
    CHECK_FALSE(pixelDifference[0] == pixelDifference[1]);
    CHECK_FALSE(pixelDifference[1] == pixelDifference[2]);
    CHECK_FALSE(pixelDifference[2] == pixelDifference[3]);
    CHECK_FALSE(pixelDifference[2] == pixelDifference[4]);
  }
}

TEST_CASE("exact: few surfaces stay apart, and those that the GPU counts") {
  testContext();
  const JoiningForced asked("yes");
  HeapStage stage;
  draw::JoinedSurfaces joined;
  std::vector<sim::Surface> surfaces = stage.drawables.surfaces;
  CHECK(joined.join(surfaces));
  CHECK(joined.surface().indexCount == 3 * (7 * 40 + 2 * 8 * 6));
  CHECK(joined.surface().vertexCount == 7 * 3 * 40 + 9 * 7);
  CHECK_FALSE(joined.join({surfaces[0], surfaces[1]}));
  const gl::Buffer arguments("arguments", 5 * sizeof(GLuint));
  surfaces[4].arguments = &arguments;
  CHECK_FALSE(joined.join(surfaces));
  surfaces = stage.drawables.surfaces;
  scene::Material shadowless = *surfaces[0].material;
  shadowless.castsShadow = false;
  surfaces[0].material = &shadowless;
  CHECK_FALSE(joined.join(surfaces));
  const JoiningForced refused("maybe");
  CHECK_THROWS_AS(joined.join(surfaces), UserError);
}

TEST_CASE("scenery says that it stands still, each mesh by a number of its own; what deforms does not") {
  testContext();
  const scene::Scene scene = scene::parseScene(
      R"({"version": 1, "stage": false, "sun": {"shadow": false}, "objects": {
          "a": {"sphere": {}}, "b": {"capsule": {"position": {"keys": [[0, [0, 0, 0]], [1, [1, 0, 0]]]}}},
          "c": {"mesh": {"resolution": [5, 4]}}, "d": {"cloth": {"size": [9, 7]}},
          "e": {"mesh": {"resolution": [5, 4], "deform": [{"ripple": {}}], "technique": "compute"}},
          "f": {"mesh": {"resolution": [5, 4], "deform": [{"ripple": {}}], "technique": "vertex-shader"}}}})",
      "test.json", {}, sim::kinds());
  sim::World world(scene);
  std::map<std::string, unsigned> numbers;
  for (int frame = 0; frame < 3; ++frame) {
    world.advanceTo(frame);
    for (const sim::Surface& surface : world.drawables().surfaces) {
      const auto [found, isNew] = numbers.emplace(objectName(surface), surface.still);
      CHECK(found->second == surface.still);
    }
  }
  CHECK(numbers.size() == 6);
  const std::set<unsigned> still = {numbers["a"], numbers["b"], numbers["c"], 0U};
  CHECK(still.size() == 4);
  for (const char* moving : {"d", "e", "f"}) CHECK(numbers[moving] == 0);
}
