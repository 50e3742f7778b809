// Tests particles and cloth in the wind of a moving fluid. They must equal their CPU twins word by word.
#include "gpu/context.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "reference/particles_twin.hpp"
#include "reference/spread_twin.hpp"
#include "scene/load.hpp"
#include "sim/fluid/parameters.hpp"
#include "sim/spread/grid.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"

#include <bit>
#include <cstdint>
#include <string>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double windFrame = 1.0 / 60.0;

/// Returns a scene with an object in the wind of a fluid. The object precedes the fluid in the scene, so
/// that the test fails if the objects step in this order.
scene::Scene windyScene(const std::string& blown) {
  return scene::parseScene(fmt::format(R"({{"version": 1, "seed": 5, "objects": {{"blown": {{{}}},
    "storm": {{"fluid": {{"size": [37, 22], "speed": 90, "flow": [8, 0, 0], "sides": {{"left": "open", "right": "open"}},
      "plane": {{"position": [0.1, 0.4, 0.1], "rotation": [20, 35, -15], "cell": 0.06}},
      "obstacles": [{{"center": [18, 9, 0], "radius": 3.3}}],
      "strokes": [{{"until": 9, "from": [6, 12, 0], "radius": 4, "velocity": [70, -25, 0], "dye": [1, 0, 0]}}]}}}}}}}})",
                                       blown),
                           "test.json", {}, sim::kinds());
}

std::size_t wordsThatDiffer(const gl::Buffer& buffer, const std::vector<glm::vec4>& expected) {
  const auto got = buffer.readAll<std::uint32_t>();
  REQUIRE(got.size() == expected.size() * 4);
  std::size_t different = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    different += got[i] == std::bit_cast<std::uint32_t>(expected[i / 4][static_cast<int>(i % 4)]) ? 0 : 1;
  return different;
}

template <class Twin>
void checkInWind(const scene::Scene& scene, Twin twin, int frames) {
  testContext();
  sim::World world(scene);
  const auto& fluid = dynamic_cast<const sim::FluidParameters&>(*scene.objects.at(1).parameters);
  twin.wind.emplace();
  twin.wind->grid = sim::fluidWindGrid(fluid.plane, fluid.size);
  for (int frame = 1; frame <= frames; ++frame) {
    world.advanceTo(frame);
    CAPTURE(frame);
    twin.wind->flow = world.object(1).state()[0].readAll<glm::vec4>();
    twin.step((frame - 1) * windFrame);
    const auto state = world.object(0).state();
    REQUIRE(wordsThatDiffer(*state[0].buffer, twin.positions) == 0);
    REQUIRE(wordsThatDiffer(*state[1].buffer, twin.velocities) == 0);
  }
  testContext().check();
}

}  // namespace

TEST_CASE("fluid wind: particles in a fluid's wind equal their CPU twin") {
  for (const char* method : {"none", "all-pairs"}) {
    CAPTURE(method);
    const auto scene =
        windyScene(fmt::format(R"("particles": {{"method": "{}", "substeps": 2, "gravity": 0.001,
      "wind": {{"fluid": "storm", "drag": 5}}, "damping": 0.3, "turbulence": {{"strength": 2}},
      "groups": [{{"shape": "cube", "count": 333, "radius": 1.1, "position": [0.1, 0.4, 0.2], "speed": 1}}],
      "emitters": [{{"rate": 300, "position": [-0.4, 0.4, 0], "lifetime": 0.3, "velocity": [1, 1, 0]}}]}})",
                               method));
    const auto& p = dynamic_cast<const sim::ParticleParameters&>(*scene.objects.at(0).parameters);
    checkInWind(scene, ParticlesTwin(sim::ParticlePlan(p, 5, windFrame)), 12);
  }
}

TEST_CASE("fluid wind: sheets in a fluid's wind equal their CPU twin") {
  for (const char* solver : {R"("solver": "springs", "mass": 0.004, "stiffness": 60)",
                             R"("solver": "constraints", "mass": 0.004)", R"("fabric": "cotton")"}) {
    CAPTURE(std::string(solver));
    const auto scene = windyScene(fmt::format(R"("cloth": {{"size": [21, 17], "spacing": 0.06, {},
      "position": [0.1, 0.5, 0.1], "rotation": [70, 20, 0], "substeps": 6,
      "air": {{"velocity": [0.4, 0, 0.1], "gusts": 0.3, "fluid": "storm"}}}})",
                                              solver));
    const auto& p = dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters);
    checkInWind(scene, ClothTwin(sim::ClothPlan(p, 5, windFrame, {})), 8);
  }
}

TEST_CASE("fluid wind: mesh cloth in a fluid's wind equals its CPU twin") {
  const auto scene = windyScene(R"("cloth": {"mesh": {"shape": "disc", "radius": 0.5}, "fabric": "silk",
    "position": [0.1, 0.5, 0.1], "rotation": [70, 20, 0], "substeps": 6, "air": {"fluid": "storm"}})");
  const auto& p = dynamic_cast<const sim::ClothParameters&>(*scene.objects.at(0).parameters);
  checkInWind(scene, GarmentTwin(sim::GarmentPlan("blown", p, 5, windFrame, {})), 8);
}

TEST_CASE("fluid wind: a wildfire in a fluid's wind equals its CPU twin") {
  testContext();
  for (const char* more :
       {R"("slope": 0.4)", R"("embers": {"chance": 0.03, "distance": 20})", R"("relief": 9)"}) {
    CAPTURE(more);
    const auto scene = windyScene(fmt::format(R"("wildfire": {{"size": [83, 61], "stepsPerSecond": 90, {},
      "border": "torus", "wind": {{"fluid": "storm", "strength": {{"keys": [[0, 1.5], [0.3, 3]]}}}},
      "strokes": [{{"from": [20, 30, 0], "radius": 4}}]}})",
                                              more));
    const auto& p = dynamic_cast<const sim::WildfireParameters&>(*scene.objects.at(0).parameters);
    const auto& fluid = dynamic_cast<const sim::FluidParameters&>(*scene.objects.at(1).parameters);
    sim::World world(scene);
    WildfireTwin twin(sim::WildfirePlan(p, "blown", 5, windFrame));
    twin.wind.emplace();
    twin.wind->grid = sim::fluidWindGrid(fluid.plane, fluid.size);
    const auto start = twin.cells;
    for (int frame = 1; frame <= 24; ++frame) {
      world.advanceTo(frame);
      twin.wind->flow = world.object(1).state()[0].readAll<glm::vec4>();
      twin.blow((frame - 1) * windFrame, fluid.speed);
      twin.step((frame - 1) * windFrame);
    }
    const auto got = world.object(0).state()[0].readAll<glm::uvec4>();
    CHECK(got == sim::packedCells(twin.cells, p.size));
    CHECK(twin.cells != start);
  }
  testContext().check();
}
