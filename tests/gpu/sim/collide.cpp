// Cloth and particles that touch shapes, bodies and meshes: beside their CPU twins, word by word.
#include "gpu/context.hpp"
#include "reference/particles_twin.hpp"
#include "sim/body/bones.hpp"
#include "sim/world/list.hpp"
#include "sim/world/setup.hpp"
#include "sim/world/world.hpp"
#include "source_folder.hpp"

#include <bit>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double collideSeconds = 1.0 / 60.0;

std::size_t unlikeWords(const gl::Buffer& buffer, const std::vector<glm::vec4>& expected) {
  const auto got = buffer.readAll<std::uint32_t>();
  REQUIRE(got.size() == expected.size() * 4);
  std::size_t different = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    different += got[i] == std::bit_cast<std::uint32_t>(expected[i / 4][static_cast<int>(i % 4)]) ? 0 : 1;
  return different;
}

scene::Scene collideScene(const std::string& objects) {
  return scene::parseScene(fmt::format(R"({{"version": 1, "seed": 5, "objects": {{{}}}}})", objects),
                           "test.json", {}, sim::kinds());
}

/// Steps the first object of a scene and its twin. Returns how far the speeds are from those of one that
/// touches nothing.
template <class Twin>
void compareTouching(const scene::Scene& scene, Twin& twin, int frames) {
  testContext();
  sim::World world(scene);
  for (int frame = 1; frame <= frames; ++frame) {
    world.advanceTo(frame);
    twin.step((frame - 1) * collideSeconds);
    REQUIRE(unlikeWords(*world.object(0).state()[0].buffer, twin.positions) == 0);
    REQUIRE(unlikeWords(*world.object(0).state()[1].buffer, twin.velocities) == 0);
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
    const auto scene = collideScene(fmt::format(R"(
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
