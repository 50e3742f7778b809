#include "gpu/context.hpp"
#include "reference/garment_twin.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <bit>
#include <cstdint>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Steps the GPU garment and its CPU twin and compares every word of the state and of the normals.
void compareGarment(const sim::ClothParameters& parameters, int frames,
                    const std::vector<sim::ColliderShape>& colliders = {}) {
  testContext();
  constexpr double frameSeconds = 1.0 / 60.0;
  scene::Object object;
  object.name = "dress";
  object.kind = "cloth";
  object.parameters = std::make_unique<sim::ClothParameters>(parameters);
  const sim::Setting setting{false, 5, frameSeconds, &colliders};
  const auto gpu = sim::simulationNamed("cloth").make(object, setting);
  GarmentTwin twin(sim::GarmentPlan("dress", parameters, 5, frameSeconds, colliders));
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
  CHECK(travelled > 0.1);
  const auto table = *gpu->mesh();
  const auto normals = twin.normals();
  std::size_t different = 0;
  for (std::size_t i = 0; i < table.normals.size(); ++i) {
    const unsigned vertex = twin.plan().cloth().vertexOf[i];
    different += table.normals[i] == normals[vertex] ? 0 : 1;
    different += table.positions[i] == glm::vec3(twin.positions[vertex]) ? 0 : 1;
  }
  CHECK(different == 0);
  CHECK(gpu->points().values.size() == 6 * table.positions.size());
  const auto measured = gpu->measure();
  CHECK(measured.size() == parameters.quantities().size());
  CHECK(measured[0] == static_cast<double>(twin.plan().masses().size()));
}

}  // namespace

TEST_CASE("garment: a disc in gusting air that falls onto moving colliders equals its CPU twin") {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->shape = sim::ClothShape::disc;
  p.mesh->radius = 0.6F;
  p.mesh->resolution = {27, 3};
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.air.emplace();
  p.air->velocity = glm::vec3(2, 0.5F, 1);
  p.air->gusts = 0.6F;
  p.jitter = 0.002F;
  p.position = glm::vec3(0.1F, 0.7F, 0);
  sim::ColliderShape ball;
  ball.position = scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {1.0, glm::vec3(0.5F, 0.2F, 0)}},
                                             scene::Ease::smooth);
  ball.radius = 0.5F;
  ball.friction = 0.3;
  sim::ColliderShape floor;
  floor.kind = sim::ColliderShape::Kind::plane;
  floor.position = glm::vec3(0, -0.2F, 0);
  compareGarment(p, 40, {ball, floor});
}

TEST_CASE("garment: a random mesh on moving pins equals its CPU twin") {
  const test::TemporaryFile file("twin.obj",
                                 test::objOf(test::rectangle(test::Kind::random, {23, 17}, 0.03)));
  sim::ClothParameters p = test::freeCloth();
  p.mesh->shape = sim::ClothShape::file;
  p.mesh->file = file.path();
  p.mesh->scale = 1.25F;
  p.fabric->material = sim::FabricMaterial::denim;
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.rotation = glm::vec3(70, 20, 0);
  p.damping = 1;
  p.pins.emplace_back().vertices = {0, 23, 200};
  p.pins[0].rotate =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {0.5, glm::vec3(30, 40, -5)}}, scene::Ease::linear);
  compareGarment(p, 30);
  p.fabric->stretchDamping = 0.01;
  compareGarment(p, 20);
}

TEST_CASE("garment: clamped borders equal their CPU twin") {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->size = glm::vec3(0.5F, 0, 0.4F);
  p.mesh->resolution = {13, 11};
  p.fabric->material = sim::FabricMaterial::canvas;
  p.gravity = glm::vec3(0, -9.8F, 0);
  test::pinBox(p, glm::vec3(-9), glm::vec3(-0.24F, 9, 9));
  p.pins[0].clamp = true;
  p.pins[0].rotate =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {0.5, glm::vec3(5, 10, 40)}}, scene::Ease::linear);
  for (const float damping : {0.0F, 0.1F}) {
    p.damping = damping;
    compareGarment(p, 20);
  }
}

TEST_CASE("garment: attachments equal their CPU twin") {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->size = glm::vec3(1, 0, 0.8F);
  p.mesh->resolution = {37, 31};
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.fabric->bending = 1e-7;
  p.substeps = 8;
  p.pins.emplace_back().vertices = {0, 36, 700};
  for (const float damping : {0.0F, 0.1F}) {  // Undamped garments use the energy-conserving solver.
    p.damping = damping;
    CHECK(sim::GarmentPlan("a", p, 5, 1.0 / 60, {}).arrays().attachments.size() == 37 * 31 - 3);
    compareGarment(p, 20);
  }
}

TEST_CASE("garment: closed shapes equal their CPU twin") {
  for (const auto shape : {sim::ClothShape::sphere, sim::ClothShape::torus, sim::ClothShape::cylinder}) {
    sim::ClothParameters p = test::freeCloth();
    p.mesh->shape = shape;
    p.mesh->resolution = {9, 7};
    p.fabric->material = sim::FabricMaterial::rubber;
    p.gravity = glm::vec3(0, -9.8F, 0);
    sim::ColliderShape floor;
    floor.kind = sim::ColliderShape::Kind::plane;
    floor.position = glm::vec3(0, -1.1F, 0);
    for (const float damping : {0.0F, 0.1F}) {
      p.damping = damping;
      compareGarment(p, 40, {floor});
    }
  }
}

TEST_CASE("garment: seams equal their CPU twin") {
  sim::ClothParameters p = test::freeCloth();
  p.mesh->shape = sim::ClothShape::disc;
  p.mesh->resolution = {15, 3};
  p.gravity = glm::vec3(0, -9.8F, 0);
  test::pinBox(p, glm::vec3(-0.1F), glm::vec3(0.1F));
  // The seams join vertices of the outermost ring (127 to 168). One vertex is in two seams.
  p.seams.push_back({{127, 130, 131, 140}, {129, 140, 150, 160}, 0.2});
  p.seams.push_back({{128}, {165}, 0.4});
  compareGarment(p, 30);
}
