// Tests known facts about automata on the CPU twin, and compares the twin with a plain loop over
// neighbours.
#include "base/error.hpp"
#include "reference/life_twin.hpp"
#include "source_folder.hpp"
#include "unit/help.hpp"
#include "unit/sim/notation_help.hpp"

#include <bit>
#include <random>

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::checkHas;
using namespace simreel::sim;

namespace {

LifeParameters grid(int width, int height, const char* pattern = nullptr, glm::ivec2 at = {0, 0}) {
  LifeParameters p;
  p.size = {width, height};
  p.stepsPerSecond = 10;
  if (pattern == nullptr) return p;
  p.fill = 0;
  LifePattern placed;
  placed.file = sourceFolder() + "/assets/patterns/" + pattern + ".rle";
  placed.at = at;
  p.patterns.push_back(placed);
  return p;
}

LifeTwin twinOf(const LifeParameters& p, int seed = 1) {
  return LifeTwin(LifePlan(p, "cells", seed, 0.1));
}

long population(const LifeTwin& twin) {
  long count = 0;
  for (const std::uint32_t word : twin.words) count += std::popcount(word);
  return count;
}

std::string mistake(const LifeParameters& p) {
  return test::mistakeIn([&] { return twinOf(p); });
}

}  // namespace

TEST_CASE("the bit-sliced twin equals a plain loop for random rules, both borders and odd sizes") {
  std::mt19937 random(5);
  for (const glm::ivec2 size : {glm::ivec2(33, 7),
                                {257, 13},
                                {31, 5},
                                {1, 1},
                                {2, 3},
                                {1, 9},
                                {128, 4},
                                {127, 3},
                                {129, 2},
                                {64, 3}}) {
    for (int trial = 0; trial < 12; ++trial) {
      auto p = grid(size.x, size.y);
      LifeRule rule{static_cast<int>(random() % 512), static_cast<int>(random() % 512)};
      p.rule = trial == 0 ? "B3/S23" : rule.text();
      p.border = trial % 2 == 0 ? LifeBorder::torus : LifeBorder::dead;
      p.fill = 0.1F + 0.07F * static_cast<float>(trial);
      auto twin = twinOf(p, trial);
      auto cells = bytesOf(twin.words, size);
      for (int i = 0; i < 5; ++i) {
        twin.generation(1 + trial % 2);
        cells = nextBytes(cells, size, twin.plan().rule().counts, twin.plan().torus());
        REQUIRE(twin.words == wordsOf(cells, size));  // The comparison also checks that bits beyond a row's
                                                      // end are zero.
      }
    }
  }
}

TEST_CASE("the fast byte loop of the benchmark equals the plain one") {
  const glm::ivec2 size(45, 17);
  auto cells = bytesOf(twinOf(grid(size.x, size.y)).words, size);
  const std::size_t pitch = 47;
  std::vector<std::uint8_t> padded(pitch * 19);
  std::vector<std::uint8_t> next(padded.size());
  for (std::size_t i = 0; i < cells.size(); ++i) padded[(i / 45 + 1) * pitch + i % 45 + 1] = cells[i];
  for (int step = 0; step < 20; ++step) {
    fastBytes(padded, next, size);
    std::swap(padded, next);
    cells = nextBytes(cells, size, LifeRule{}, true);
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
    REQUIRE(padded[(i / 45 + 1) * pitch + i % 45 + 1] == cells[i]);
}

TEST_CASE("a glider moves one cell diagonally down in four generations") {
  auto twin = twinOf(grid(41, 37, "glider", {3, 5}));
  const auto expected = twinOf(grid(41, 37, "glider", {4 + 30, 6 + 30}));
  for (int i = 0; i < 4 * 31; ++i) {
    CHECK(population(twin) == 5);
    twin.generation();
  }
  CHECK(twin.words == expected.words);
  // The glider travels around the torus back to its start.
  for (int i = 0; i < 4 * 41 * 37 - 4 * 31; ++i) twin.generation();
  CHECK(twin.words == twinOf(grid(41, 37, "glider", {3, 5})).words);
}

TEST_CASE("Gosper's gun sends a glider every 30 generations") {
  auto p = grid(300, 200, "gosper_gun", {4, 4});
  p.border = LifeBorder::dead;
  auto twin = twinOf(p);
  CHECK(population(twin) == 36);
  for (int shot = 1; shot <= 12; ++shot) {
    for (int i = 0; i < 30; ++i) twin.generation();
    CHECK(population(twin) == 36 + 5 * shot);
  }
}

TEST_CASE("the R-pentomino settles at generation 1,103 with 116 cells") {
  auto p = grid(1001, 999, "r_pentomino", {500, 500});
  p.border = LifeBorder::dead;
  auto twin = twinOf(p);
  for (int i = 0; i < 1102; ++i) twin.generation();
  CHECK(population(twin) == 118);
  twin.generation();
  CHECK(population(twin) == 116);
  for (int i = 0; i < 60; ++i) {
    twin.generation();
    CHECK(population(twin) == 116);
  }
}

TEST_CASE("a glider becomes a block at a dead border") {
  auto p = grid(23, 19, "glider", {4, 2});
  p.border = LifeBorder::dead;
  auto twin = twinOf(p);
  for (int i = 0; i < 200; ++i) twin.generation();
  CHECK(population(twin) == 4);
}

TEST_CASE("the acorn pattern of seven cells can be rotated and flipped") {
  auto p = grid(20, 20, "acorn", {2, 3});
  p.rule = "B/S012345678";  // In this rule every cell survives.
  const auto cells = [&](int rotate, LifePattern::Flip flip) {
    p.patterns[0].rotate = rotate;
    p.patterns[0].flip = flip;
    const auto bytes = bytesOf(twinOf(p).words, p.size);
    std::string shape;
    for (int y = 3; y < 10; ++y)
      for (int x = 2; x < 9; ++x) shape += bytes[static_cast<std::size_t>(y * 20 + x)] != 0 ? 'o' : '.';
    return shape;
  };
  using Flip = LifePattern::Flip;
  const std::string empty = ".......";
  const std::string below = empty + empty + empty + empty;
  CHECK(cells(0, Flip::none) ==
        ".o....."
        "...o..."
        "oo..ooo" +
            below);
  CHECK(cells(180, Flip::none) ==
        "ooo..oo"
        "...o..."
        ".....o." +
            below);
  CHECK(cells(0, Flip::horizontal) ==
        ".....o."
        "...o..."
        "ooo..oo" +
            below);
  CHECK(cells(0, Flip::vertical) ==
        "oo..ooo"
        "...o..."
        ".o....." +
            below);
  CHECK(cells(90, Flip::none) ==
        "o......"
        "o.o...."
        "......."
        ".o....."
        "o......"
        "o......"
        "o......");
  CHECK(cells(270, Flip::none) ==
        "..o...."
        "..o...."
        "..o...."
        ".o....."
        "......."
        "o.o...."
        "..o....");
  CHECK(cells(90, Flip::horizontal) ==
        "o......"
        "o......"
        "o......"
        ".o....."
        "......."
        "o.o...."
        "o......");
}

TEST_CASE("a pattern across the edge of a torus continues on the other side") {
  const auto here = twinOf(grid(37, 29, "glider", {36, 28}));
  const auto there = twinOf(grid(37, 29, "glider", {-1, -1}));
  CHECK(here.words == there.words);
  CHECK(population(here) == 5);
}

TEST_CASE("generations are due at floor(time * rate) for any frame rate") {
  for (const double fps : {60.0, 24.0, 25.0, 30.0, 7.0, 144.0}) {
    auto p = grid(9, 9);
    for (const double rate : {10.0, 3.0, 60.0, 1000.0, 0.5}) {
      p.stepsPerSecond = rate;
      const LifePlan plan(p, "cells", 1, 1 / fps);
      int max = 0;
      for (int second = -3; second < 60; ++second) {
        const auto frame = static_cast<long>(second * fps);
        CHECK(plan.frameAt(static_cast<double>(frame) / fps) == frame);
        CHECK(plan.generationAt(frame) == static_cast<long>(std::floor(second * rate)));
        for (long f = frame; f < frame + static_cast<long>(fps); ++f)
          max = std::max(max, static_cast<int>(plan.generationAt(f + 1) - plan.generationAt(f)));
      }
      CHECK(max == plan.stepsPerFrame());
    }
  }
}

TEST_CASE("the random start has the requested fraction of living cells and depends on the seed") {
  auto p = grid(1003, 997);
  for (const float fraction : {0.0F, 0.1F, 0.3F, 0.9F, 1.0F}) {
    p.fill = fraction;
    const double measured = static_cast<double>(population(twinOf(p))) / (1003.0 * 997.0);
    CHECK(measured == doctest::Approx(static_cast<double>(fraction)).epsilon(0.005));
  }
  p.fill = 0.5F;
  const auto a = twinOf(p, 1);
  const auto b = twinOf(p, 2);
  long different = 0;
  for (std::size_t i = 0; i < a.words.size(); ++i) different += std::popcount(a.words[i] ^ b.words[i]);
  CHECK(static_cast<double>(different) / (1003.0 * 997.0) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("patterns that do not fit are refused") {
  auto p = grid(20, 20, "gosper_gun", {0, 0});
  checkHas(mistake(p), "gosper_gun.rle has 36 x 9 cells, more than the grid's 20 x 20");
  p = grid(40, 20, "gosper_gun", {6, 0});
  CHECK(mistake(p) == "no mistake");
  p.border = LifeBorder::dead;
  checkHas(mistake(p), "at [6, 0] reaches to [41, 8], outside the grid of 40 x 20");
  p.patterns[0].at = {2, -1};
  checkHas(mistake(p), "outside the grid");
  p.patterns[0].at = {2, 3};
  CHECK(mistake(p) == "no mistake");
}
