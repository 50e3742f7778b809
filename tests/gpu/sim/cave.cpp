#include "sim/cave/cave.hpp"

#include "gpu/context.hpp"
#include "reference/cave_twin.hpp"
#include "sim/cave/growth.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

sim::CaveParameters cave(int width, int height) {
  sim::CaveParameters p;
  p.size = {width, height};
  return p;
}

/// Returns caves of odd sizes, of one cell, with more than one word per row, and with rows that fill whole
/// words and groups of words.
std::vector<sim::CaveParameters> someCaves() {
  std::vector<sim::CaveParameters> all = {cave(1, 1),    cave(1, 40),  cave(77, 1),
                                          cave(3, 3),    cave(61, 43), cave(128, 33),
                                          cave(131, 97), cave(32, 64), cave(300, 7)};
  all.push_back(cave(97, 83));
  all.back().fill = 0.5;  // This fraction makes many small rooms.
  all.push_back(cave(97, 83));
  all.back().fill = 0.52;
  all.back().smallestRoom = 0;
  all.back().smallestRock = 0;
  all.back().corridor = 1;
  all.push_back(cave(65, 71));
  all.back().fill = 0.5;
  all.back().corridor = 7;
  all.push_back(cave(45, 37));
  all.back().fill = 0;
  all.push_back(cave(45, 37));
  all.back().fill = 1;
  all.push_back(cave(67, 45));
  all.back().smoothing = 0;
  all.back().smallestRoom = 0;
  all.back().smallestRock = 0;
  all.back().corridor = 2;
  return all;
}

void checkCells(const sim::CaveGrowth& growth, const CaveTwin& twin, const char* stage) {
  CAPTURE(stage);
  const auto got = growth.cells().buffer().readAll<glm::uvec4>();
  CHECK(got == twin.words());
}

/// Returns the minimum total distance that connects all rooms, from Prim's spanning tree over the Manhattan
/// distances of all pairs of cells.
long minLength(const CaveTwin& twin, glm::ivec2 size) {
  const std::vector<int> region = twin.regions(false);
  std::map<int, std::vector<glm::ivec2>> rooms;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      if (const int r = region[twin.index(x, y)]; r >= 0) rooms[r].emplace_back(x, y);
  const auto distance = [](const auto& a, const auto& b) {
    long minimum = std::numeric_limits<long>::max();
    for (const glm::ivec2 p : a)
      for (const glm::ivec2 q : b)
        minimum = std::min(minimum, static_cast<long>(std::abs(p.x - q.x) + std::abs(p.y - q.y)));
    return minimum;
  };
  if (rooms.empty()) return 0;
  std::map<int, long> open;
  for (const auto& [r, cells] : rooms)
    if (r != rooms.begin()->first) open[r] = distance(cells, rooms.begin()->second);
  long sum = 0;
  while (!open.empty()) {
    const auto nearest = std::min_element(open.begin(), open.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    sum += nearest->second;
    const int joined = nearest->first;
    open.erase(nearest);
    for (auto& [r, minimum] : open) minimum = std::min(minimum, distance(rooms[r], rooms[joined]));
  }
  return sum;
}

}  // namespace

TEST_CASE("a cave equals its twin at every stage") {
  testContext();
  int seed = 5;
  for (const sim::CaveParameters& p : someCaves()) {
    CAPTURE(p.size.x);
    CAPTURE(p.size.y);
    CAPTURE(p.fill);
    CaveTwin twin(p, ++seed);
    sim::CaveGrowth growth("cave", p, seed);
    checkCells(growth, twin, "noise");
    for (int i = 1; i <= p.smoothing; ++i) {
      growth.advance(i);
      twin.smooth();
    }
    checkCells(growth, twin, "smooth");
    growth.advance(p.smoothing + 1);
    twin.clean();
    checkCells(growth, twin, "clean");
    growth.advance(p.lastStage());
    twin.connect();
    checkCells(growth, twin, "connected");
    const auto ends = twin.ends();
    REQUIRE(ends.has_value() == (growth.way().entrance != sim::noCell));
    if (!ends) continue;
    CHECK(growth.grid().placeOf(growth.way().entrance) == ends->first);
    CHECK(growth.grid().placeOf(growth.way().exit) == ends->second);
    const std::vector<int> steps = twin.distancesFrom(ends->first);
    const auto shown = growth.distances().buffer().readAll<float>();
    const auto pitch = static_cast<std::size_t>(32 * growth.grid().rowWords());
    std::size_t different = 0;
    for (int y = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x)
        if (shown[static_cast<std::size_t>(y) * pitch + static_cast<std::size_t>(x)] !=
            static_cast<float>(steps[twin.index(x, y)]))
          ++different;
    CHECK(different == 0);
    const auto& path = growth.way().path;
    CHECK(path.size() == static_cast<std::size_t>(steps[twin.index(ends->second.x, ends->second.y)]) + 1);
    for (std::size_t i = 0; i < path.size(); ++i) {
      CHECK(!twin.isRock(path[i].x, path[i].y));
      if (i > 0) CHECK(std::abs(path[i].x - path[i - 1].x) + std::abs(path[i].y - path[i - 1].y) == 1);
    }
  }
}

TEST_CASE("the cells of a cave between two stages equal their twin") {
  testContext();
  for (sim::CaveParameters p : {cave(1, 1), cave(131, 37)}) {
    p.stepSeconds = 1;
    p.transition = 1;
    CaveTwin twin(p, 9);
    sim::CaveGrowth growth("cave", p, 9);
    const auto pitch = static_cast<std::size_t>(32 * growth.grid().rowWords());
    for (int stage = 0; stage <= p.lastStage(); ++stage) {
      const std::vector<bool> before = twin.rock;
      growth.advance(stage);
      if (stage > p.smoothing + 1)
        twin.connect();
      else if (stage > p.smoothing)
        twin.clean();
      else if (stage > 0)
        twin.smooth();
      for (const float fraction : {0.0F, 0.3F, 0.5F, 1.0F}) {
        if (stage == 0 && fraction < 1) continue;
        growth.blend(fraction);
        const auto got = growth.blended().buffer().readAll<float>();
        const std::vector<float> expected = twin.blended(before, fraction);
        std::size_t different = 0;
        for (int y = 0; y < p.size.y; ++y)
          for (int x = 0; x < p.size.x; ++x)
            if (got[static_cast<std::size_t>(y) * pitch + static_cast<std::size_t>(x)] !=
                expected[twin.index(x, y)])
              ++different;
        CAPTURE(stage);
        CAPTURE(fraction);
        CHECK(different == 0);
      }
    }
  }
}

TEST_CASE("the solid of a growing cave moves between stages without jumps") {
  testContext();
  sim::CaveParameters p = cave(61, 43);
  p.stepSeconds = 1;
  p.transition = 0.5;
  CHECK(p.transitionAt(0) == 1);
  CHECK(p.transitionAt(2) < 1e-5F);
  CHECK(p.transitionAt(2.25) == doctest::Approx(0.5).epsilon(1e-4));
  CHECK(p.transitionAt(2.75) == 1);
  CHECK(p.transitionAt(100) == 1);
  sim::CaveGrowth growth("cave", p, 5);
  sim::Solid solid("cave", p.shape(0));
  sim::Field field;
  field.cells = sim::Field::Cells::floats;
  field.size = p.size;
  field.rowWords = 32 * growth.grid().rowWords();
  const auto volumeAt = [&](float fraction) {
    growth.blend(fraction);
    field.words = &growth.blended().view();
    solid.make(field, {0, 1});
    solid.grow();
    const sim::MeshTable mesh = solid.mesh();
    double sum = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      sum += glm::dot(mesh.positions[mesh.indices[i]], glm::cross(mesh.positions[mesh.indices[i + 1]],
                                                                  mesh.positions[mesh.indices[i + 2]])) /
             6;
    return sum;
  };
  const double cell = static_cast<double>(p.cell) * static_cast<double>(p.cell);
  double last = volumeAt(1);
  for (int stage = 1; stage <= p.lastStage(); ++stage) {
    growth.advance(stage);
    CAPTURE(stage);
    CHECK(std::abs(volumeAt(0) - last) < 1e-3 * cell);
    last = volumeAt(0);
    double largest = 0;
    for (int i = 1; i <= 64; ++i) {
      const double volume = volumeAt(static_cast<float>(i) / 64);
      largest = std::max(largest, std::abs(volume - last));
      last = volume;
    }
    CHECK(largest < 20 * cell);  // of 2623 cells
  }
}

TEST_CASE("all open cells of a cave are connected by corridors of minimum total length") {
  testContext();
  for (int seed = 1; seed <= 12; ++seed) {
    sim::CaveParameters p = cave(70 + seed, 61);
    p.fill = 0.46 + 0.006 * seed;
    p.corridor = 1 + seed % 4;
    CaveTwin twin(p, seed);
    for (int i = 0; i < p.smoothing; ++i) twin.smooth();
    twin.clean();
    CHECK(twin.corridorLength() == minLength(twin, p.size));
    sim::CaveGrowth growth("cave", p, seed);
    growth.advance(p.lastStage());
    const auto cells = growth.cells().buffer().readAll<unsigned>();
    for (int y = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x)
        twin.rock[twin.index(x, y)] =
            (cells[static_cast<std::size_t>(y * growth.grid().rowWords() + x / 32)] >> (x % 32) & 1U) != 0;
    const std::vector<int> regions = twin.regions(false);
    std::set<int> rooms(regions.begin(), regions.end());
    rooms.erase(-1);
    CHECK(rooms.size() <= 1);
  }
}

TEST_CASE("a spiral and a comb are one region: labels propagate along every direction") {
  testContext();
  const glm::ivec2 size(67, 65);
  const sim::CaveGrid grid{size};
  std::vector<std::uint32_t> words(static_cast<std::size_t>(grid.words()), ~0U);
  const auto open = [&](int x, int y) {
    words[static_cast<std::size_t>(y * grid.rowWords() + x / 32)] &= ~(1U << static_cast<unsigned>(x % 32));
  };
  int cells = 0;
  glm::ivec2 at(1, 1), way(1, 0);
  std::set<std::pair<int, int>> seen;
  for (int turns = 0; turns < 2 && cells < 5000;) {
    if (seen.insert({at.x, at.y}).second) ++cells;
    open(at.x, at.y);
    const glm::ivec2 next = at + way;
    const glm::ivec2 beyond = next + way;
    const bool blocked = next.x < 1 || next.y < 1 || next.x >= size.x - 1 || next.y >= size.y - 1 ||
                         seen.contains({beyond.x, beyond.y});
    if (blocked) {
      way = {-way.y, way.x};
      ++turns;
      continue;
    }
    turns = 0;
    at = next;
  }
  const gl::Buffer buffer = gl::Buffer::of<std::uint32_t>("spiral", words);
  sim::CaveRegions regions("spiral", grid);
  regions.label(buffer, sim::CaveKind::open);
  const auto largest = regions.largest(buffer);
  CHECK(largest.cells == static_cast<unsigned>(cells));
  CHECK(largest.first == 32U * static_cast<unsigned>(grid.rowWords()) + 1);
  sim::CaveWaves waves("spiral", grid);
  CHECK(waves.run(buffer, largest.first).steps == static_cast<unsigned>(cells - 1));
}
