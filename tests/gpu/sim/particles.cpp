#include "sim/particles/particles.hpp"

#include "base/error.hpp"
#include "gpu/context.hpp"
#include "gpu/sim/words.hpp"
#include "reference/particles_twin.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/particles/pairs.hpp"

#include <algorithm>
#include <cstdint>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double particleFrame = 1.0 / 60.0;

using Colliders = std::vector<sim::ColliderShape>;

std::unique_ptr<sim::Simulation> makeParticles(const sim::ParticleParameters& parameters, bool fast = false,
                                               const Colliders& colliders = {}) {
  testContext();
  scene::Object object;
  object.name = "cloud";
  object.kind = "particles";
  object.parameters = std::make_unique<sim::ParticleParameters>(parameters);
  return sim::particlesKind().make(object, {fast, 5, particleFrame, &colliders});
}

/// Steps the GPU particles and their CPU twin and compares every word of the state. Returns the twin for
/// further checks.
ParticlesTwin compare(const sim::ParticleParameters& parameters, int frames, double start = 0,
                      const Colliders& colliders = {}) {
  const auto gpu = makeParticles(parameters, false, colliders);
  ParticlesTwin twin(sim::ParticlePlan(parameters, 5, particleFrame, 1 << 24, colliders));
  const auto before = twin.positions;
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(start + frame * particleFrame, {});
    twin.step(start + frame * particleFrame);
  }
  const auto state = gpu->state();
  CHECK(wordsUnlike(*state[0].buffer, twin.positions) == 0);
  CHECK(wordsUnlike(*state[1].buffer, twin.velocities) == 0);
  if (state.size() > 2) {
    CHECK(wordsUnlike(*state[2].buffer, twin.spins) == 0);
    CHECK(wordsUnlike(*state[3].buffer, twin.turns) == 0);
  }
  double travelled = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    travelled += glm::abs(before[i].x - twin.positions[i].x) + glm::abs(before[i].y - twin.positions[i].y);
  CHECK(travelled > 0.01);  // The test would be useless if nothing moved.
  CHECK(gpu->status()->readAll<unsigned>()[0] == 0xffffffffU);
  return twin;
}

sim::ParticleParameters cloud(sim::ParticleGroup::Shape shape, int count, float mass = 100) {
  sim::ParticleParameters p;
  auto& group = p.groups.emplace_back();
  group.shape = shape;
  group.count = count;
  group.totalMass = mass;
  return p;
}

void addFields(sim::ParticleParameters& p) {
  p.attractor.emplace();
  p.attractor->position = scene::Animated<glm::vec3>(
      {{0.0, glm::vec3(2, 0, 0)}, {0.5, glm::vec3(0, 1, -1)}}, scene::Ease::smooth);
  p.attractor->mass = scene::Animated<float>({{0.0, 50.0F}, {0.3, 300.0F}}, scene::Ease::linear);
  p.turbulence.strength = 0.7F;
  p.turbulence.size = 0.4F;
  p.damping = 0.3F;
  p.acceleration = glm::vec3(0, -0.5F, 0.1F);
  p.substeps = 3;
}

void addEmitters(sim::ParticleParameters& p) {
  auto& fountain = p.emitters.emplace_back();
  fountain.rate = 333;
  fountain.lifetime = 0.4F;
  fountain.radius = 0.2F;
  fountain.mass = 0.5F;
  auto& jet = p.emitters.emplace_back();
  jet.rate = 77;
  jet.lifetime = 0.2F;
  jet.lifetimeVariation = 0.8F;
  jet.position = scene::Animated<glm::vec3>({{0.0, glm::vec3(-1, 0, 0)}, {1.0, glm::vec3(1, 0, 1)}},
                                            scene::Ease::linear);
  jet.velocity = glm::vec3(1, 0, -2);
  jet.spread = 120;
  jet.from = 0.1F;
  jet.until = 0.6F;
}

}  // namespace

TEST_CASE("particles: all pairs equal the CPU twin") {
  for (const int count : {257, 1021}) {
    CAPTURE(count);
    auto p = cloud(sim::ParticleGroup::Shape::ball, count);
    p.groups[0].speed = 0.3F;
    compare(p, count < 500 ? 60 : 12);
  }
}

TEST_CASE("particles: all pairs with fields and emitters equal the CPU twin") {
  auto p = cloud(sim::ParticleGroup::Shape::disk, 251);
  p.groups[0].centralMass = 30;
  p.groups[0].rotation = glm::vec3(20, 0, 40);
  addFields(p);
  addEmitters(p);
  const auto twin = compare(p, 45);
  int alive = 0;
  int dead = 0;
  for (const auto& v : twin.velocities) (v.w < 0 ? dead : alive) += 1;
  CHECK(alive > 252 + 50);
  CHECK(dead > 10);
}

TEST_CASE("particles: fields alone equal the CPU twin") {
  for (const int count : {257, 1021}) {
    auto p = cloud(sim::ParticleGroup::Shape::cube, count);
    p.method = sim::GravityMethod::none;
    p.groups[0].spin = 1;
    addFields(p);
    addEmitters(p);
    compare(p, 90, -0.25);
  }
}

TEST_CASE("particles: balls in contact equal the CPU twin") {
  auto p = cloud(sim::ParticleGroup::Shape::cube, 257, 2.57F);
  p.groups[0].radius = 0.3F;
  p.groups[0].speed = 2;
  p.method = sim::GravityMethod::none;
  p.contact.emplace().radius = 0.03F;
  p.margin = 0.03F;
  addFields(p);
  p.attractor->mass = 3000.0F;
  auto& second = p.groups.emplace_back();
  second.shape = sim::ParticleGroup::Shape::ball;
  second.count = 20;
  second.totalMass = 2;
  second.radius = 0.3F;
  second.position = glm::vec3(0.5F, 0, 0);
  SUBCASE("of one size, with emitters") {
    addEmitters(p);
  }
  SUBCASE("of sizes that grow with mass") {
    p.massExponent = 0.333F;
  }
  SUBCASE("that attract each other") {
    p.method = sim::GravityMethod::allPairs;
  }
  SUBCASE("that roll") {
    p.contact->rolls = true;
    p.collides = true;
    addEmitters(p);
  }
  SUBCASE("that attract each other and roll") {
    p.contact->rolls = true;
    p.method = sim::GravityMethod::allPairs;
  }
  Colliders colliders(p.collides ? 1 : 0);
  for (sim::ColliderShape& plane : colliders) {
    plane.kind = sim::ColliderShape::Kind::plane;
    plane.position = glm::vec3(0, -0.1F, 0);
    plane.friction = 0.5;
  }
  const auto twin = compare(p, 30, 0, colliders);
  CHECK(twin.plan().parameters().substeps == 3);
  float fastest = 0;
  for (const glm::vec4& spin : twin.spins) fastest = std::max(fastest, glm::length(glm::vec3(spin)));
  CHECK((fastest > 1) == p.contact->rolls);
}

TEST_CASE("particles: tree and fast numerics place newborn particles like exact pairs") {
  auto p = cloud(sim::ParticleGroup::Shape::ball, 1, 12);
  p.groups[0].radius = 1e-4F;
  p.gravity = 1;
  p.softening = 0.5F;
  p.damping = 0.3F;
  p.acceleration = glm::vec3(0, -0.5F, 0.1F);
  addEmitters(p);
  for (auto& emitter : p.emitters) emitter.mass = 1e-6F;
  const auto after = [&](sim::GravityMethod method, bool fast) {
    p.method = method;
    const auto gpu = makeParticles(p, fast);
    for (int frame = 0; frame < 40; ++frame) gpu->step(frame * particleFrame, {});
    return gpu->state()[0].buffer->readAll<glm::vec4>();
  };
  const auto expected = after(sim::GravityMethod::allPairs, false);
  for (const auto method : {sim::GravityMethod::allPairs, sim::GravityMethod::tree})
    for (const bool fast : {false, true}) {
      CAPTURE(fast);
      const auto got = after(method, fast);
      float worst = 0;
      for (std::size_t i = 0; i < got.size(); ++i)
        for (int axis = 0; axis < 4; ++axis)
          worst = std::max(worst, glm::abs(got[i][axis] - expected[i][axis]));
      CHECK(worst < 1e-4F);
    }
}

TEST_CASE("particles: a Plummer sphere of more than one chunk equals its CPU twin") {
  compare(cloud(sim::ParticleGroup::Shape::plummer, 2 * 1024 + 173), 3);
}

TEST_CASE("particles: gravity of 70,001 bodies includes every body") {
  // Loops of more than 65,535 iterations end silently on some software drivers. Bodies with larger indices
  // must still have an effect.
  testContext();
  constexpr int count = 70001;
  std::vector<glm::vec4> bodies;
  for (unsigned i = 0; i < count; ++i) {
    const auto bits = shader::hash3({i, 3, 9});
    bodies.emplace_back(shader::signedUnit(bits.x), shader::signedUnit(bits.y), shader::signedUnit(bits.z),
                        i < 65000 ? 1e-4F : 1.0F);
  }
  const gl::Vec4Array positions("bodies", bodies);
  const std::vector<glm::vec4> untouched(count, glm::vec4(7, 7, 7, 7));
  for (const int split : {0, 1, 5000}) {
    CAPTURE(split);
    const gl::Vec4Array accelerations("accelerations", untouched);
    sim::PairGravity gravity(false);
    if (split > 0) gravity.splitAfter(split);
    const glm::ivec2 targets(69990, count - 2);
    gravity.accelerate(positions, accelerations, count, 0.01F, 0.1F, targets);
    const auto got = accelerations.buffer().readAll<glm::vec4>();
    for (int i = targets.x - 3; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      glm::vec4 expected(7, 7, 7, 7);
      if (i >= targets.x && i < targets.y)
        expected = glm::vec4(pairAcceleration(bodies, glm::vec3(bodies[at]), 0.01F, 0.1F), 0);
      CHECK(got[at] == expected);
    }
  }
}

TEST_CASE("particles: four targets per invocation give the same bits as one") {
  testContext();
  const int count = 3 * 1024 + 517;
  std::vector<glm::vec4> bodies;
  for (int i = 0; i < count; ++i) {
    const auto bits = shader::hash3({static_cast<unsigned>(i), 3, 9});
    bodies.emplace_back(shader::signedUnit(bits.x), shader::signedUnit(bits.y), shader::signedUnit(bits.z),
                        1.5F);
  }
  const gl::Vec4Array positions("bodies", bodies);
  std::vector<glm::vec4> results[2];
  for (const int many : {0, 1}) {
    const gl::Vec4Array accelerations("accelerations", std::vector<glm::vec4>(bodies.size(), glm::vec4(7)));
    sim::PairGravity gravity(false);
    if (many == 1) gravity.useManyFrom(1);
    gravity.accelerate(positions, accelerations, count, 0.01F, 0.1F, {5, count - 3});
    results[many] = accelerations.buffer().readAll<glm::vec4>();
  }
  CHECK(results[0] == results[1]);
  CHECK(results[1][4] == glm::vec4(7));
  CHECK(results[1][5] != glm::vec4(7));
  CHECK(results[1][static_cast<std::size_t>(count) - 4] != glm::vec4(7));
  CHECK(results[1][static_cast<std::size_t>(count) - 3] == glm::vec4(7));
}

TEST_CASE("particles: a NaN particle is reported with its index") {
  for (const auto method : {sim::GravityMethod::none, sim::GravityMethod::allPairs}) {
    auto p = cloud(sim::ParticleGroup::Shape::ball, 131);
    p.acceleration = glm::vec3(1e6F, 0, 0);
    p.method = method;
    const auto gpu = makeParticles(p);
    for (int frame = 0; frame < 1100 && gpu->status()->readAll<unsigned>()[0] == 0xffffffffU; ++frame)
      gpu->step(frame * particleFrame, {});
    const auto words = gpu->status()->readAll<unsigned>();
    REQUIRE(words[0] != 0xffffffffU);
    CHECK(words[1] < 131);
    const std::string line = gpu->explainLoss(words[0], words[1]);
    CHECK(line.find("\"cloud\"") != std::string::npos);
    CHECK(line.find("substeps") != std::string::npos);
  }
}

TEST_CASE("particles: too many particles are refused before memory is allocated") {
  auto p = cloud(sim::ParticleGroup::Shape::ball, 1 << 24);
  for (int i = 0; i < 60; ++i) p.groups.push_back(p.groups[0]);
  CHECK_THROWS_AS(makeParticles(p), UserError);
}

TEST_CASE("particles: published instances are views of the state") {
  auto p = cloud(sim::ParticleGroup::Shape::ball, 257, 514);
  const auto gpu = makeParticles(p);
  sim::Drawables drawables;
  gpu->publish(0, drawables);
  REQUIRE(drawables.instances.size() == 1);
  const auto& instances = drawables.instances[0];
  CHECK(instances.capacity == 257);
  CHECK(instances.massReference == 2.0F);
  REQUIRE(instances.positions != nullptr);
  REQUIRE(instances.velocities != nullptr);
  CHECK(instances.colors->size() >= 2);
}
