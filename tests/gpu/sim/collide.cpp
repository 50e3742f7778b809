// Tests cloth and particles that touch shapes, bodies and meshes. They must equal their CPU twins word by
// word.
#include "gpu/context.hpp"
#include "gpu/sim/words.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "reference/particles_twin.hpp"
#include "sim/body/bones.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/world/list.hpp"
#include "sim/world/setup.hpp"
#include "sim/world/world.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"
#include "unit/sim/collide_help.hpp"

#include <cstdint>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double collideSeconds = 1.0 / 60.0;

/// Steps the first object of a scene and its CPU twin, and compares the two after each frame.
template <class Twin>
void compareTouching(const scene::Scene& scene, Twin& twin, int frames) {
  testContext();
  sim::World world(scene);
  for (int frame = 1; frame <= frames; ++frame) {
    world.advanceTo(frame);
    twin.step((frame - 1) / 60.0);
    REQUIRE(wordsUnlike(*world.object(0).state()[0].buffer, twin.positions) == 0);
    REQUIRE(wordsUnlike(*world.object(0).state()[1].buffer, twin.velocities) == 0);
  }
}

std::vector<sim::ColliderShape> shapesOf(const scene::Scene& scene) {
  const sim::Bones bones(scene);
  return sim::collidersOf(scene, &bones);
}

}  // namespace

TEST_CASE("collide: particles on a walking body and shapes that move equal their CPU twin") {
  for (const char* method : {"none", "all-pairs"}) {
    CAPTURE(method);
    const auto scene = test::parsedScene(fmt::format(R"(
      "grains": {{"particles": {{"method": "{}", "gravity": 0.001, "collides": true, "bounce": 0.4, "margin": 0.02,
        "acceleration": [0, -9.81, 0], "substeps": 5,
        "groups": [{{"shape": "cube", "count": 333, "radius": 0.4, "position": [0, 1.6, 0], "speed": 0.5}}],
        "emitters": [{{"rate": 200, "position": [0, 1, 0.9], "lifetime": 0.7, "velocity": [0, 0, -4]}}]}}}},
      "walker": {{"body": {{"file": "{}/assets/meshes/walker.gltf", "animation": "walk", "collides": true,
        "friction": 0.3}}}},
      "ball": {{"sphere": {{"radius": 0.3, "position": {{"keys": [[0, [0.5, 1, 0]], [1, [-0.5, 1.2, 0]]]}}}}}},
      "rod": {{"capsule": {{"radius": 0.1, "length": 1.3, "rotation": {{"keys": [[0, [90, 0, 0]], [1, [90, 60, 0]]]}},
        "position": [0.4, 0.5, 0], "friction": 0.4}}}},
      "ramp": {{"plane": {{"rotation": [10, 0, 20], "position": [0, 0.1, 0]}}}})",
                                                     method, sourceFolder()));
    const auto shapes = shapesOf(scene);
    CHECK(shapes.size() > 10);
    ParticlesTwin twin(
        sim::ParticlePlan(dynamic_cast<const sim::ParticleParameters&>(*scene.objects.at(0).parameters), 5,
                          collideSeconds, 1 << 24, shapes));
    compareTouching(scene, twin, 40);
  }
}

namespace {

/// Returns the scene text of a box that falls and rotates, a torus and a ball.
std::string movingMeshes(const test::TemporaryFile& box) {
  return fmt::format(
      R"("box": {{"mesh": {{"shape": "file", "file": "{}", "scale": 0.9, "collides": true, "friction": 0.4,
      "distanceCells": 33, "position": {{"keys": [[0, [0.1, 0.9, 0]], [1, [0.2, -0.4, 0.3]]]}},
      "rotation": {{"keys": [[0, [10, 0, 40]], [1, [200, 90, 0]]]}}}}}},
    "ring": {{"mesh": {{"shape": "torus", "radius": 0.7, "tube": 0.17, "resolution": [31, 17], "collides": true,
      "position": [0, 0.1, 0], "rotation": [7, 0, 0], "grip": 3}}}},
    "ball": {{"sphere": {{"radius": 0.2, "position": [0.7, 0.2, 0]}}}})",
      box.path().string());
}

sim::MeshColliderPlan planOf(const scene::Scene& scene) {
  return sim::MeshColliderPlan(scene, sim::meshReach(scene));
}

}  // namespace

TEST_CASE("collide: distance fields equal their CPU twin, also if a search takes many rounds") {
  testContext();
  const test::TemporaryFile file("field.obj", test::boxObj({0.37, 0.21, 0.3}));
  // The centre of a sphere is equally close to all faces of the sphere, so a search from there takes many
  // iterations.
  const auto scene = test::parsedScene(movingMeshes(file) + R"(,
    "globe": {"mesh": {"shape": "sphere", "radius": 0.4, "resolution": [301, 203], "collides": true,
      "distanceCells": 22}})");
  const DistanceTwin twin(sim::MeshColliderPlan(scene, 0.03));
  const sim::DistanceFields fields(sim::MeshColliderPlan(scene, 0.03));
  const auto cells = fields.cells().buffer().readAll<glm::uvec4>();
  REQUIRE(cells.size() == twin.cells.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) different += cells[i] == twin.cells[i] ? 0 : 1;
  CHECK(different == 0);
}

TEST_CASE("collide: particles on meshes that move equal their CPU twin") {
  const test::TemporaryFile file("grains.obj", test::boxObj({0.3, 0.2, 0.4}));
  for (const char* method : {"none", "all-pairs"}) {
    CAPTURE(method);
    const auto scene = test::parsedScene(fmt::format(R"(
      "grains": {{"particles": {{"method": "{}", "gravity": 0.001, "collides": true, "bounce": 0.4, "margin": 0.03,
        "acceleration": [0, -9.81, 0], "substeps": 3,
        "groups": [{{"shape": "cube", "count": 333, "radius": 0.6, "position": [0, 0.8, 0], "speed": 0.5}}],
        "emitters": [{{"rate": 200, "position": [0, 1, 0.9], "lifetime": 0.7, "velocity": [0, -2, -40]}}]}}}}, {})",
                                                     method, movingMeshes(file)));
    ParticlesTwin twin(
        sim::ParticlePlan(dynamic_cast<const sim::ParticleParameters&>(*scene.objects.at(0).parameters), 5,
                          collideSeconds, 1 << 24, shapesOf(scene)));
    twin.meshes.emplace(planOf(scene));
    compareTouching(scene, twin, 40);
  }
}

TEST_CASE("collide: cloth on meshes that move equals its CPU twin") {
  const test::TemporaryFile file("cloth.obj", test::boxObj({0.3, 0.2, 0.4}));
  const auto sceneOf = [&](const std::string& cloth) {
    return test::parsedScene(
        fmt::format(R"("sheet": {{"cloth": {{"position": [0.1, 0.4, 0.05], "wind": [0, 0, 0],
      "margin": 0.02, {}}}}}, {})",
                    cloth, movingMeshes(file)));
  };
  const auto parameters = [](const scene::Scene& scene) {
    return dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters);
  };
  for (const char* solver : {R"("mass": 0.004, "stiffness": 60)", R"("fabric": {"material": "cotton"})"}) {
    CAPTURE(solver);
    const auto scene =
        sceneOf(std::string(R"("size": [35, 23], "spacing": 0.05, "pins": [], "substeps": 9, )") + solver);
    ClothTwin twin(sim::ClothPlan(parameters(scene), 5, collideSeconds, shapesOf(scene)));
    twin.meshes.emplace(planOf(scene));
    compareTouching(scene, twin, 25);
  }
  const auto scene = sceneOf(
      R"("mesh": {"shape": "disc", "radius": 0.8, "resolution": [19, 3]}, "fabric": {"material": "canvas"})");
  GarmentTwin twin(sim::GarmentPlan("sheet", parameters(scene), 5, collideSeconds, shapesOf(scene)));
  twin.meshes.emplace(planOf(scene));
  compareTouching(scene, twin, 25);
}

TEST_CASE("collide: cloth on rods and balls thinner than its mesh equals its CPU twin") {
  const char* const thin = R"("rod": {"capsule": {"radius": 0.01, "length": 0.9, "friction": 0.3,
      "position": {"keys": [[0, [0, 0.3, 0]], [0.1, [0.1, -0.3, 0]], [1, [0, 0.2, 0.3]]]},
      "rotation": {"keys": [[0, [0, 20, 90]], [1, [0, 70, 80]]]}}},
    "bead": {"sphere": {"radius": 0.012, "position": {"keys": [[0, [0.3, 0.5, 0.2]], [0.2, [0.31, -0.4, 0.2]]]}}},
    "floor": {"plane": {"position": [0, -0.6, 0]}},
    "stake": {"capsule": {"radius": 0.2, "length": 0.4, "position": [-0.4, -0.4, 0.2]}})";
  const auto sceneOf = [&](const std::string& cloth) {
    return test::parsedScene(
        fmt::format(R"("sheet": {{"cloth": {{"position": [0.1, 0, 0.05], "rotation": [4, 9, 0],
      "wind": [0, 0, 0], "margin": 0.005, {}}}}}, {})",
                    cloth, thin));
  };
  const auto parameters = [](const scene::Scene& scene) {
    return dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters);
  };
  for (const char* solver : {R"("mass": 0.004, "stiffness": 60)", R"("fabric": {"material": "cotton"})"}) {
    CAPTURE(solver);
    const auto scene = sceneOf(
        std::string(
            R"("size": [25, 19], "spacing": 0.05, "pins": [{"corners": ["top-left"]}], "substeps": 9, )") +
        solver);
    ClothTwin twin(sim::ClothPlan(parameters(scene), 5, collideSeconds, shapesOf(scene)));
    CHECK(twin.plan().thinCount() == 2);
    compareTouching(scene, twin, 20);
  }
  const auto scene = sceneOf(
      R"("mesh": {"shape": "disc", "radius": 0.6, "resolution": [11, 3]}, "fabric": {"material": "canvas"})");
  GarmentTwin twin(sim::GarmentPlan("sheet", parameters(scene), 5, collideSeconds, shapesOf(scene)));
  CHECK(twin.plan().thinCount() == 2);
  compareTouching(scene, twin, 20);
}
