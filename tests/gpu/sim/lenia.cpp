#include "sim/lenia/lenia.hpp"

#include "gpu/context.hpp"
#include "reference/lenia_twin.hpp"

#include <cmath>
#include <memory>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::sim;

namespace {

std::unique_ptr<Simulation> leniaOf(const LeniaParameters& p) {
  scene::Object object;
  object.name = "sea";
  object.kind = "lenia";
  object.parameters = std::make_unique<LeniaParameters>(p);
  static const std::vector<ColliderShape> colliders;
  return leniaKind().make(object, {false, 5, 1.0 / 30, &colliders});
}

LeniaParameters sea(glm::ivec2 size) {
  LeniaParameters p;
  p.size = size;
  p.patches = 6;
  return p;
}

void compareLenia(const LeniaParameters& p, int steps = 6) {
  testContext();
  const auto gpu = leniaOf(p);
  LeniaTwin twin(LeniaPlan(p, "sea", 5, 1.0 / 30));
  for (int i = 0; i < steps; ++i) {
    gpu->step(i / 30.0, {});
    twin.step();
  }
  REQUIRE(gpu->state()[0].buffer->readAll<glm::vec4>() == twin.cells);
}

}  // namespace

TEST_CASE("lenia equals its CPU twin: sizes, kernels, growth functions") {
  for (const glm::ivec2 size : {glm::ivec2(61, 43), {64, 20}, {5, 70}, {3, 2}}) compareLenia(sea(size));
  auto p = sea({50, 47});
  p.kernels.resize(3);
  p.kernels[0].rings = {50, 100, 67};
  p.kernels[0].mu = 0.21;
  p.kernels[0].growth = LeniaKernel::Growth::gaussian;
  p.kernels[1].radius = 8.5;
  p.kernels[1].core = LeniaKernel::Core::exponential;
  p.kernels[1].weight = 0.5;
  p.kernels[2].radius = 4;
  p.kernels[2].growth = LeniaKernel::Growth::step;
  p.kernels[2].sigma = 0.1;
  p.kernels[2].weight = -0.3;
  compareLenia(p);
}

TEST_CASE("smooth life equals its CPU twin") {
  auto p = sea({57, 40});
  p.model = LeniaParameters::Model::smoothLife;
  p.radius = 9;
  p.timeScale = 5;
  compareLenia(p);
}

TEST_CASE("lenia on the GPU equals its equation in double precision") {
  testContext();
  auto p = sea({48, 40});
  p.patches = 3;
  const auto gpu = leniaOf(p);
  LeniaInDouble twin(LeniaPlan(p, "sea", 5, 1.0 / 30));
  for (int i = 0; i < 8; ++i) {
    gpu->step(i / 30.0, {});
    twin.step();
  }
  const auto cells = gpu->state()[0].buffer->readAll<float>();
  double worst = 0, mass = 0;
  for (std::size_t i = 0; i < twin.cells.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(cells[i]) - twin.cells[i]));
    mass += twin.cells[i];
  }
  CHECK(mass > 10);
  CHECK(worst < 2e-5);
}

TEST_CASE("smooth life on the GPU equals its paper's equations in double precision") {
  testContext();
  auto p = sea({44, 40});
  p.model = LeniaParameters::Model::smoothLife;
  p.radius = 9;
  p.timeScale = 5;
  // With a radius of 7.4, no cell lies at the distance where the disc's ramp is 0.5. The four limits of
  // birth and survival all differ.
  for (const double radius : {9.0, 7.4}) {
    p.radius = radius;
    p.surviveMax = 0.46;
    const auto gpu = leniaOf(p);
    SmoothLifeInDouble twin(LeniaPlan(p, "sea", 5, 1.0 / 30));
    for (int i = 0; i < 6; ++i) {
      gpu->step(i / 30.0, {});
      twin.step();
    }
    const auto cells = gpu->state()[0].buffer->readAll<float>();
    double worst = 0;
    int between = 0;
    for (std::size_t i = 0; i < twin.cells.size(); ++i) {
      worst = std::max(worst, std::abs(static_cast<double>(cells[i]) - twin.cells[i]));
      between += twin.cells[i] > 0.1 && twin.cells[i] < 0.9 ? 1 : 0;
    }
    CHECK(between > 50);
    CHECK_MESSAGE(worst < 1e-4, (worst));
  }
}

TEST_CASE("an orbium keeps its shape and moves half its kernel's radius per unit of time") {
  testContext();
  LeniaParameters p;
  p.size = {80, 80};
  p.creatures.resize(1);
  p.patches = 0;
  p.stepsPerSecond = 30;
  const auto gpu = leniaOf(p);
  const auto middle = [&] {
    const auto cells = gpu->state()[0].buffer->readAll<float>();
    double sx = 0, cx = 0, sy = 0, cy = 0;
    for (int i = 0; i < 80 * 80; ++i) {
      const double value = static_cast<double>(cells[static_cast<std::size_t>(i)]);
      const double ax = 2 * std::acos(-1.0) * (i % 80) / 80, ay = 2 * std::acos(-1.0) * (i / 80) / 80;
      sx += value * std::sin(ax);
      cx += value * std::cos(ax);
      sy += value * std::sin(ay);
      cy += value * std::cos(ay);
    }
    const double per = 80 / (2 * std::acos(-1.0));
    return glm::dvec2(std::atan2(sx, cx) * per, std::atan2(sy, cy) * per);
  };
  for (int i = 0; i < 60; ++i) gpu->step(i / 30.0, {});
  const glm::dvec2 from = middle();
  const double mass = gpu->measure()[0];
  for (int i = 60; i < 110; ++i) gpu->step(i / 30.0, {});  // The 50 frames are five units of time.
  glm::dvec2 way = middle() - from;
  for (int c = 0; c < 2; ++c) way[c] -= 80 * std::round(way[c] / 80);
  CHECK(gpu->measure()[0] == doctest::Approx(mass).epsilon(0.02));
  CHECK(mass == doctest::Approx(73.6).epsilon(0.02));
  CHECK(std::hypot(way.x, way.y) / 5 / 13 == doctest::Approx(0.478).epsilon(0.02));
}
