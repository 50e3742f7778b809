// Tests automata of all families, cell by cell, by comparison with the plain loops of
// tests/reference/states_twin.cpp.
#include "base/error.hpp"
#include "gpu/context.hpp"
#include "reference/life_twin.hpp"
#include "reference/states_twin.hpp"
#include "sim/life/life.hpp"
#include "unit/help.hpp"

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::sim;

namespace {

LifeParameters soupOf(const char* rule, GridBorder border, glm::ivec2 size) {
  LifeParameters p;
  p.size = size;
  p.rule = rule;
  p.border = border;
  p.stepsPerSecond = 40;
  p.fill = 0.4F;
  return p;
}

std::unique_ptr<Simulation> automatonOf(const LifeParameters& p, int seed) {
  scene::Object object;
  object.name = "cells";
  object.kind = "life";
  object.parameters = std::make_unique<LifeParameters>(p);
  static const std::vector<ColliderShape> colliders;
  return lifeKind().make(object, {false, seed, 0.1, &colliders});
}

void compareStates(const LifeParameters& p, int frames = 4, int seed = 3) {
  testContext();
  CAPTURE(p.rule);
  CAPTURE(static_cast<int>(p.border));
  CAPTURE(p.size.x);
  const auto gpu = automatonOf(p, seed);
  const LifePlan plan(p, "cells", seed, 0.1);
  if (plan.rule().states > 2) {
    StatesTwin twin(plan);
    for (int frame = 0; frame < frames; ++frame) {
      gpu->step(frame * 0.1, {});
      twin.step(frame * 0.1);
    }
    REQUIRE(gpu->state()[0].buffer->readAll<std::uint8_t>() == twin.rows());
    return;
  }
  LifeTwin twin(plan);
  for (int frame = 0; frame < frames; ++frame) {
    gpu->step(frame * 0.1, {});
    twin.step(frame * 0.1);
  }
  REQUIRE(gpu->state()[0].buffer->readAll<std::uint32_t>() == twin.words);
  if (!twin.trail.empty()) REQUIRE(gpu->state()[1].buffer->readAll<std::uint32_t>() == twin.trail);
}

constexpr GridBorder allBorders[] = {GridBorder::torus,         GridBorder::dead,
                                     GridBorder::cylinder,      GridBorder::klein,
                                     GridBorder::kleinSideways, GridBorder::crossSurface};

}  // namespace

TEST_CASE("automata of every family equal their twins with every border") {
  for (const char* rule : {"B3/S23", "B2-a/S12", "B2/S013V", "345/2/4", "R3,C0,M0,S8..17,B9..12,NM",
                           "R4,C0,M1,S12..20,B10..14,NC", "R2,C4,M0,S4..7,B4..5,NN", "R2/T3/C5/NM"})
    for (const GridBorder border : allBorders) {
      compareStates(soupOf(rule, border, {67, 41}));
      compareStates(soupOf(rule, border, {16, 130}));
    }
  for (const char* rule : {"B3/S23", "/2/3"}) compareStates(soupOf(rule, GridBorder::sphere, {45, 45}));
}

TEST_CASE("automata on grids barely larger than their range equal the CPU automaton") {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {2, 3}, {5, 1}})
    for (const GridBorder border : allBorders) {
      compareStates(soupOf("345/2/4", border, size));
      compareStates(soupOf("B2-a/S12", border, size));
    }
  for (const glm::ivec2 size : {glm::ivec2(7, 7), {9, 8}, {130, 7}})
    for (const char* shape : {"M", "N", "C"})
      compareStates(
          soupOf((std::string("R7,C0,M1,S20..50,B20..40,N") + shape).c_str(), GridBorder::klein, size));
}

TEST_CASE(
    "neighbourhood rules on bits equal the CPU automaton, with several generations per pass and in tiles") {
  for (const char* rule :
       {"B2-a/S12", "B3/S2-i34q", "B3aijn4w/S2ae3eijkr4z", "B2/S34H", "B13/S012V",
        "MAPARYXfhZofugWaH7oaIDogBZofuhogOiAaIDogIAAgAAWaH7oaIDogGiA6ICAAIAAaIDogIAAgACAAIAAAAAAAA"}) {
    for (const GridBorder border : {GridBorder::torus, GridBorder::dead}) {
      auto p = soupOf(rule, border, {256, 70});
      compareStates(p);
      p.size = {131, 67};
      compareStates(p);
      p.size = {96, 63};
      p.stepsPerSecond = 3013;
      compareStates(p, 1);
    }
  }
}

TEST_CASE("automata with wide ranges, and with sums that fill a byte, equal the CPU automaton") {
  for (const char* rule : {"R127,C0,M1,S20000..30000,B18000..28000,NM",
                           "R60,C0,M1,S4000..6000,B3500..5500,NC", "R33,C7,M0,S700..1300,B600..1200,NN"}) {
    auto p = soupOf(rule, GridBorder::torus, {140, 129});
    p.stepsPerSecond = 10;  // This rate gives one generation per frame.
    compareStates(p, 1);
  }
  compareStates(soupOf("R10,C0,M1,S123..212,B123..170,NM", GridBorder::torus, {150, 70}), 2);
}

TEST_CASE("ranges too large for one loop of a software driver give correct cells") {
  struct Far {
    const char* rule;
    glm::ivec2 size;
  };
  for (const Far& far : {Far{"R137,C0,M1,S9000..36000,B18000..28000,NC", {275, 281}},
                         Far{"R260,C0,M0,S60000..67850,B67800..90000,NN", {523, 540}},
                         Far{"R300,C5,M0,S70000..180500,B180400..240000,NM", {611, 603}}}) {
    testContext();
    auto p = soupOf(far.rule, GridBorder::torus, far.size);
    p.fill = 0.5F;
    p.stepsPerSecond = 10;  // This rate gives one generation per frame.
    CAPTURE(p.rule);
    const auto gpu = automatonOf(p, 3);
    const LifePlan plan(p, "cells", 3, 0.1);
    const bool bits = plan.rule().states == 2;
    const auto cellsOf = [&] {
      const auto bytes = gpu->state()[0].buffer->readAll<std::uint8_t>();
      const int row = bits ? (p.size.x + 127) / 128 * 16 : (p.size.x + 15) / 16 * 16;
      std::vector<std::uint8_t> cells;
      for (int y = 0; y < p.size.y; ++y)
        for (int x = 0; x < p.size.x; ++x) {
          const auto word = bytes[static_cast<std::size_t>(y * row + (bits ? x / 8 : x))];
          cells.push_back(bits ? word >> (x % 8) & 1 : word);
        }
      return cells;
    };
    const auto before = cellsOf();
    gpu->step(0.1, {});
    const auto after = cellsOf();
    int alive = 0;
    for (int i = 0; i < 24; ++i) {
      const glm::ivec2 at(i * 7919 % p.size.x, i * 104729 % p.size.y);
      const std::uint8_t next = nextState(before, p.size, plan.rule(), {}, at);
      CHECK(int{after[static_cast<std::size_t>(at.y * p.size.x + at.x)]} == int{next});
      alive += next == 1 ? 1 : 0;
    }
    CHECK(alive > 3);
    CHECK(alive < 21);
  }
}

TEST_CASE("neighbourhoods of any shape equal their twins") {
  // All cases use the same neighbour counts, so that few kernels are compiled.
  int turn = 0;
  for (const char* shape :
       {"2", "+", "X", "*", "#", "B", "D", "H", "A", "3", "L", "@891ABC891891", "@891A91891891L"}) {
    const std::string rule =
        std::string(turn++ % 4 == 1 ? "R3,C4,S3-6,B3-5,N" : "R3,C0,S3-6,B3-5,N") + shape;
    compareStates(soupOf(rule.c_str(), GridBorder::torus, {67, 41}));
    compareStates(soupOf(rule.c_str(), GridBorder::dead, {131, 23}), 2);
  }
  for (const char* rule :
       {"R1,C0,S3-6,B3-5,NG", "R1,C0,S3-6,B3-5,NW123401323", "R1,C0,S3-6,B3-5,NW000201030a8401020A",
        "R1,C4,S3-6,B3-5,NW1234813a3,01a2", "R1,C0,S3-6,B3-5,NW123401f23L"})
    for (const glm::ivec2 size : {glm::ivec2(67, 41), {130, 18}})
      compareStates(soupOf(rule, GridBorder::torus, size));
}

TEST_CASE("a trail follows any two-state rule as on the CPU") {
  auto p = soupOf("B3/S23", GridBorder::klein, {70, 50});
  p.trail = 9;
  p.trailGiven = true;
  compareStates(p);
  p.rule = "R2,C0,M0,S6..9,B6..8,NM";
  compareStates(p);
}

TEST_CASE("strokes paint cell states") {
  auto p = soupOf("/2/5", GridBorder::torus, {75, 52});
  StrokeParameters stroke;
  stroke.from = {-3, 20, 0};
  stroke.to = {70, 40, 0};
  stroke.until = 0.3;
  stroke.radius = 6;
  stroke.value = 3;
  p.strokes = {stroke};
  compareStates(p, 5);
}
