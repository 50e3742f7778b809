#include "gpu/context.hpp"
#include "reference/cloth_twin.hpp"
#include "sim/world/list.hpp"

#include <bit>
#include <cstdint>
#include <functional>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Steps the GPU cloth and its CPU twin and compares every word of the state.
void compare(const sim::ClothParameters& parameters, int frames,
             const std::vector<sim::ColliderShape>& colliders = {}, double frameSeconds = 1.0 / 60.0) {
  testContext();
  scene::Object object;
  object.name = "sheet";
  object.kind = "cloth";
  object.parameters = std::make_unique<sim::ClothParameters>(parameters);
  const sim::Setting setting{false, 5, frameSeconds, &colliders};
  const auto gpu = sim::simulationNamed("cloth").make(object, setting);
  ClothTwin twin(sim::ClothPlan(parameters, 5, frameSeconds, colliders));
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * frameSeconds, {});
    twin.step(frame * frameSeconds);
  }
  const auto state = gpu->state();
  const std::vector<glm::vec4>* expected[] = {&twin.positions, &twin.velocities};
  double travelled = 0;
  for (std::size_t array = 0; array < 2; ++array) {
    const auto got = state[array].buffer->readAll<std::uint32_t>();
    REQUIRE(got.size() == expected[array]->size() * 4);
    std::size_t different = 0;
    for (std::size_t i = 0; i < got.size(); ++i) {
      const float value = (*expected[array])[i / 4][static_cast<int>(i % 4)];
      different += got[i] == std::bit_cast<std::uint32_t>(value) ? 0 : 1;
      travelled += array == 1 ? std::abs(value) : 0;
    }
    CHECK_MESSAGE(different == 0, state[array].name, ": ", different, " of ", got.size(), " words differ");
  }
  CHECK(travelled > 0.1);  // The test would be useless if nothing moved.
}

sim::ClothParameters sheet(int width, int height) {
  sim::ClothParameters p;
  p.size = {width, height};
  return p;
}

}  // namespace

TEST_CASE("cloth equals its CPU twin over 300 steps on 33x21") {
  compare(sheet(33, 21), 75);
}

TEST_CASE("cloth equals its CPU twin over 300 steps on 7x5") {
  compare(sheet(7, 5), 75);
}

TEST_CASE("cloth equals its CPU twin on 131x97") {
  compare(sheet(131, 97), 10);
}

TEST_CASE("cloth in gusting air equals its CPU twin") {
  auto p = sheet(33, 21);
  p.air.emplace();
  p.air->velocity = glm::vec3(6, 0.5F, 2);
  p.air->gusts = 0.6F;
  p.mass = 0.02F;
  p.stiffness = 80;
  p.spacing = 0.05F;
  p.jitter = 0.01F;
  p.substeps.reset();
  compare(p, 60);
}

TEST_CASE("cloth over colliders with moving pins equals its CPU twin") {
  auto p = sheet(21, 33);
  p.pins[0].move = scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {0.5, glm::vec3(0.3F, -0.2F, 0.1F)}},
                                              scene::Ease::smooth);
  p.pins[0].rotate =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {1.0, glm::vec3(10, 40, -5)}}, scene::Ease::linear);
  sim::ColliderShape ball;
  ball.position = scene::Animated<glm::vec3>({{0.0, glm::vec3(0, -1, 0)}, {1.0, glm::vec3(0.5F, 0, 0)}},
                                             scene::Ease::smooth);
  ball.radius = 0.7F;
  sim::ColliderShape rod;
  rod.kind = sim::ColliderShape::Kind::capsule;
  rod.position = glm::vec3(0, -0.8F, 0.9F);
  rod.rotation = glm::vec3(0, 0, 80);
  rod.length = 1.5F;
  rod.radius = 0.2F;
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  floor.position = glm::vec3(0, -1.2F, 0);
  compare(p, 75, {ball, rod, floor});
}

TEST_CASE("cloth with constraints equals its CPU twin") {
  auto p = sheet(33, 21);
  p.solver = sim::ClothSolver::constraints;
  p.compliance = 1e-5F;
  p.shearCompliance = 1e-4F;
  sim::ColliderShape ball;
  ball.position = glm::vec3(0, -0.8F, 0);
  ball.radius = 0.6F;
  compare(p, 75, {ball});
}

TEST_CASE("constraints of a sheet in many tiles equal their CPU twin") {
  for (const bool fabric : {false, true}) {
    auto p = sheet(93, 79);
    p.solver = sim::ClothSolver::constraints;
    if (fabric) p.fabric.emplace();
    p.spacing = 0.1F;
    p.substeps = 16;
    p.mass = 1e-3F;
    p.jitter = 0.02F;
    p.pins.front().points = {{1, 77}, {92, 3}};
    compare(p, 6);
  }
}

TEST_CASE("long lines of constraints, pinned anywhere, equal their CPU twin") {
  // The first two sizes have lines of several segments whose last segment has one link. The last size has
  // lines longer than one workgroup can process.
  for (const glm::ivec2 size : {glm::ivec2(3, 130), glm::ivec2(34, 18), glm::ivec2(2, 2100)}) {
    auto p = sheet(size.x, size.y);
    p.solver = sim::ClothSolver::constraints;
    p.spacing = 0.01F;
    p.mass = 1e-4F;
    p.pins.front().points = {{1, size.y / 2}, {1, size.y / 2 + 1}};
    compare(p, 9);
  }
}

TEST_CASE("energy-conserving constraints equal their CPU twin, on lines of any length and with colliders") {
  sim::ColliderShape ball;
  ball.position = scene::Animated<glm::vec3>(
      {{0.0, glm::vec3(0, -0.8F, 0)}, {1.0, glm::vec3(0.4F, -0.7F, 0.1F)}}, scene::Ease::linear);
  ball.radius = 0.6F;
  for (const bool fabric : {false, true})
    for (const glm::ivec2 size :
         {glm::ivec2(33, 21), glm::ivec2(3, 130), glm::ivec2(34, 18), glm::ivec2(17, 2)}) {
      CAPTURE(fabric);
      CAPTURE(size.x);
      auto p = sheet(size.x, size.y);
      p.solver = sim::ClothSolver::constraints;
      if (fabric) p.fabric.emplace();
      p.spacing = 0.05F;
      p.mass = 1e-3F;
      p.wind = glm::vec3(1e-4F, 0, 2e-4F);
      p.compliance = 1e-4F;
      p.damping = 0;
      p.jitter = 0.01F;
      p.substeps = 12;
      p.pins.front().points = {{1, size.y / 2}, {size.x - 1, size.y - 1}};
      REQUIRE(p.keepsEnergy());
      compare(p, 20, {ball});
    }
}

TEST_CASE("cloth with friction on moving colliders equals its CPU twin") {
  for (const auto solver : {sim::ClothSolver::springs, sim::ClothSolver::constraints}) {
    auto p = sheet(33, 21);
    p.solver = solver;
    p.pins.clear();
    sim::ColliderShape ball;
    ball.position = scene::Animated<glm::vec3>(
        {{0.0, glm::vec3(0, -0.8F, 0)}, {1.0, glm::vec3(0.4F, -0.7F, 0.1F)}}, scene::Ease::linear);
    ball.radius = 0.6F;
    ball.friction = 0.3;
    sim::ColliderShape floor;
    floor.kind = sim::ColliderShape::Kind::plane;
    floor.position = glm::vec3(0, -1.2F, 0);
    floor.friction = 0.5;
    compare(p, 75, {ball, floor});
  }
}

TEST_CASE("fabric equals its CPU twin, clamped on all sides or on one") {
  for (const bool all : {true, false}) {
    auto p = sheet(33, 21);
    p.fabric.emplace();
    p.spacing = 0.03F;
    p.fabric->material = all ? sim::FabricMaterial::canvas : sim::FabricMaterial::rubber;
    p.air.emplace();
    p.air->gusts = 0.5F;
    p.wind = glm::vec3(0);
    p.substeps = 12;
    p.pins.clear();
    for (const int side : {0, 1, 2, 3}) {
      if (!all && side != 1) continue;
      sim::PinGroup& group = p.pins.emplace_back();
      (side < 2 ? group.columns : group.rows) = {side % 2 == 0 ? 0 : -1};
      group.clamp = true;
      group.rotate = scene::Animated<glm::vec3>(
          {{0.0, glm::vec3(0)}, {0.5, glm::vec3(20, 10.0F * side, 5)}}, scene::Ease::linear);
    }
    compare(p, 40);
    p.fabric->stretchDamping = 0.01;
    compare(p, 25);
  }
}
