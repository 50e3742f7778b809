#include "gpu/sim/spread.hpp"

#include <cmath>

#include <doctest/doctest.h>

namespace simreel::test::epidemic_sim {

namespace {

using Parameters = sim::EpidemicParameters;

Parameters city(int width, int height) {
  Parameters p;
  p.size = {width, height};
  p.stepsPerSecond = 90;
  p.infected = 0.01;
  p.beta = 0.12F;
  p.gamma = 0.1F;
  return p;
}

/// Steps the GPU simulation and its CPU twin and compares every byte of the state and every count.
void compare(const Parameters& parameters, int frames) {
  const auto gpu = spread::make(sim::epidemicKind(), parameters);
  EpidemicTwin twin(sim::EpidemicPlan(parameters, "field", 5, spread::frameSeconds));
  const auto start = twin.cells;
  CHECK(spread::rowsOf(*gpu) == twin.counts);
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * spread::frameSeconds, {});
    twin.counts = {twin.counts.back()};
    twin.step(frame * spread::frameSeconds);
    twin.counts.erase(twin.counts.begin(), twin.counts.end() - gpu->counts().rows);
    CHECK(spread::rowsOf(*gpu) == twin.counts);
  }
  const auto got = gpu->state()[0].buffer->readAll<glm::uvec4>();
  CHECK(got == sim::packedCells(twin.cells, parameters.size));  // The comparison includes the padding.
  CHECK(twin.cells != start);
}

/// Returns the numbers of susceptible, infected and recovered cells after each step.
std::vector<glm::uvec4> run(const Parameters& parameters, int frames, int seed = 5) {
  const auto gpu = spread::make(sim::epidemicKind(), parameters, seed);
  std::vector<glm::uvec4> rows = spread::rowsOf(*gpu);
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * spread::frameSeconds, {});
    const auto more = spread::rowsOf(*gpu);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

}  // namespace

TEST_CASE("epidemic equals its CPU twin on 131x97, a torus") {
  auto p = city(131, 97);
  p.border = Parameters::Border::torus;
  p.waning = 0.02F;
  compare(p, 40);
}

TEST_CASE(
    "epidemic equals its CPU twin on 33x7, closed, with strokes and with ages that advance only in some "
    "steps") {
  auto p = city(33, 7);
  p.infected = 0;
  p.beta = scene::Animated<float>({{0.0, 0.5F}, {1.0, 0.1F}}, scene::Ease::linear);
  p.gamma = 0.03F;
  p.trail = 200;
  p.strokes = {spread::dot({16, 3, 0}, 1.5F), spread::dot({31.5F, 5, 0}, 4, 0, 0.2),
               spread::dot({1, 1, 0}, 2, 1, 0.4)};
  p.strokes[1].fraction = 0.7;
  p.strokes[1].until = 0.5;
  p.strokes[1].to = {3, 2, 0};
  compare(p, 40);
}

// Software drivers skip groups of cells that cannot change. In this test, most of the grid is in such
// groups: before the outbreak arrives (also across the borders of a torus), and after all infected cells
// have recovered, until immunity wanes.
TEST_CASE("epidemic equals its CPU twin on 331x211 with mostly unchanging cells") {
  for (const auto border : {Parameters::Border::torus, Parameters::Border::closed})
    for (const int frames : {7, 45, 110}) {
      CAPTURE(frames);
      auto p = city(331, 211);
      p.border = border;
      p.infected = 0;
      p.beta = 0.7F;
      p.gamma = 0.3F;
      p.waning = scene::Animated<float>({{3.0, 0.0F}, {3.5, 0.01F}}, scene::Ease::linear);
      p.strokes = {spread::dot({330, 1, 0}, 1.5F), spread::dot({200.5F, 150.5F, 0}, 2, 1, 1.0)};
      compare(p, frames);
      // The epidemic is so slow that infected cells often do not change for several steps, and it reaches
      // the borders late.
      p.beta = 0.06F;
      p.gamma = 0.01F;
      p.trail = 200;
      p.strokes = {spread::dot({324, 60, 0}, 1.5F), spread::dot({6, 130, 0}, 1.5F)};
      compare(p, frames);
    }
}

TEST_CASE("epidemic equals its CPU twin on widths around 16 cells") {
  for (const int width : {3, 15, 16, 17, 32}) {
    auto p = city(width, 5);
    p.border = Parameters::Border::torus;
    p.infected = 0.3;
    p.waning = 0.1F;
    compare(p, 6);
  }
}

TEST_CASE("epidemic with global mixing equals its CPU twin") {
  auto p = city(131, 97);
  p.mixing = Parameters::Mixing::global;
  compare(p, 30);
}

TEST_CASE("epidemic equals its CPU twin on 2111x1033: kernel loops do not end early at a driver's limit") {
  auto p = city(2111, 1033);
  p.infected = 0.2;
  p.beta = 0.3F;
  p.waning = 0.5F;
  compare(p, 1);
}

TEST_CASE("epidemic: with fewer steps than frames, some frames repeat the state") {
  auto p = city(33, 7);
  p.infected = 0.3;
  p.stepsPerSecond = 15;
  const auto gpu = spread::make(sim::epidemicKind(), p);
  CHECK(gpu->stepsPerFrame() == 1);
  int steps = 0;
  int watched = 0;
  for (int frame = 0; frame < 10; ++frame) {
    gpu->step(frame * spread::frameSeconds, [&](int) { ++watched; });
    steps += gpu->counts().rows;
  }
  CHECK(steps == 5);
  CHECK(watched == 10);
  compare(p, 10);
}

TEST_CASE("epidemic: the number of people is constant; without waning S never grows and R never shrinks") {
  const auto rows = run(city(131, 97), 60);
  REQUIRE(rows.size() == 181);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    REQUIRE(rows[i].x + rows[i].y + rows[i].z == 131 * 97);
    REQUIRE(rows[i].w == 0);
    REQUIRE(rows[i].x <= rows[i - 1].x);
    REQUIRE(rows[i].z >= rows[i - 1].z);
  }
  CHECK(rows.back().z > 6000);  // Most people have been infected.
  CHECK(run(city(131, 97), 20, 6) != run(city(131, 97), 20, 5));
}

TEST_CASE("epidemic: waning immunity keeps the epidemic going") {
  auto p = city(131, 97);
  CHECK(run(p, 200).back().y == 0);
  p.waning = 0.02F;
  CHECK(run(p, 200).back().y > 100);
}

// The test makes one step from a known state. A susceptible cell with n infected neighbours must become
// infected with probability 1 - (1 - beta)^n. On a torus whose columns are alternately infected, n is 6
// everywhere, and the number of new infections is binomial.
TEST_CASE("epidemic: the infection probability is 1 - (1 - beta)^n, the recovery probability gamma") {
  auto p = city(510, 301);
  p.border = Parameters::Border::torus;
  p.stepsPerSecond = 30;
  p.infected = 0;
  p.beta = 0.1F;
  p.gamma = 0.3F;
  for (int x = 0; x < 510; x += 2) {
    auto line = spread::dot({static_cast<float>(x) + 0.5F, -1, 0}, 0.4F);
    line.shape = sim::StrokeParameters::Shape::line;
    line.to = {static_cast<float>(x) + 0.5F, 302, 0};
    p.strokes.push_back(line);
  }
  const auto rows = run(p, 1);
  const double half = 255 * 301;
  const auto near = [&](double got, double chance) {
    return std::abs(got - chance * half) < 4 * std::sqrt(half * chance * (1 - chance));
  };
  CHECK(near(half - rows[1].x, 1 - std::pow(0.9, 6)));
  CHECK(near(rows[1].z, 0.3));
}

// The expected value is the mean-field limit (Kermack and McKendrick). In a large mixed population, dS/S =
// -8 beta I/N to first order in a step, where S are the susceptible and I the infected of N people. An
// infection lasts 1/gamma steps on average, so ln(s_end/s_0) = -R0 (1 - s_end) with the susceptible
// fraction s and R0 = 8 beta / gamma. The exact rule of a step, 1 - (1 - beta I/N)^8, adds -4 beta^2
// (I/N)^2 per step, which the recursion below includes. The final size deviates from this limit with
// standard deviation sqrt(v/N), where v = (s (1-s) + c^2 R0^2 s^2 (1-s)) / (1 - R0 s)^2 and c^2 = 1 - gamma
// for geometrically distributed durations (von Bahr and Martin-Loef, 1980).
TEST_CASE("epidemic: the final size of a mixed population is the mean-field limit") {
  auto p = city(1023, 769);
  p.mixing = Parameters::Mixing::global;
  p.stepsPerSecond = 600;
  p.infected = 0.01;
  p.beta = 0.02F;
  p.gamma = 0.1F;
  const auto rows = run(p, 40);
  const double people = 1023.0 * 769.0;
  REQUIRE(rows.back().y < 30);
  const double got = rows.back().x / people;

  double s = rows[0].x / people;
  double i = rows[0].y / people;
  for (int step = 0; step < 800; ++step) {
    const double ill = s * (1 - std::pow(1 - 0.02 * i, 8));
    s -= ill;
    i += ill - 0.1 * i;
  }
  const double r0 = 8 * 0.02 / 0.1;
  const double deviation =
      std::sqrt((s * (1 - s) + 0.9 * r0 * r0 * s * s * (1 - s)) / ((1 - r0 * s) * (1 - r0 * s)) / people);
  INFO("left over: ", got, ", recursion ", s, ", standard deviation ", deviation);
  CHECK(deviation < 0.003);
  CHECK(std::abs(got - s) < 4 * deviation);
  double limit = 0.5;
  for (int k = 0; k < 200; ++k) limit = rows[0].x / people * std::exp(-r0 * (1 - limit));
  CHECK(std::abs(got - limit) < 4 * deviation + 0.002);
}

}  // namespace simreel::test::epidemic_sim
