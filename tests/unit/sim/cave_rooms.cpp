#include "sim/cave/rooms.hpp"

#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Converts rows of '#' and '.' to the GPU's layout of cells.
std::vector<unsigned> cellsOf(const sim::CaveGrid& grid, const std::vector<std::string>& rows) {
  std::vector<unsigned> cells(static_cast<std::size_t>(grid.words()), ~0U);
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (std::size_t x = 0; x < rows[y].size(); ++x)
      if (rows[y][x] == '.')
        cells[y * static_cast<std::size_t>(grid.rowWords()) + x / 32] &= ~(1U << x % 32);
  return cells;
}

/// Flood-fills the region around a cell with rock. Returns the number of cells and adds their positions to
/// `sum`.
long filled(std::vector<std::string>& rows, std::size_t x, std::size_t y, glm::dvec2& sum) {
  std::vector<std::pair<std::size_t, std::size_t>> todo = {{x, y}};
  long count = 0;
  while (!todo.empty()) {
    const auto [cx, cy] = todo.back();
    todo.pop_back();
    if (rows[cy][cx] != '.') continue;
    rows[cy][cx] = '#';
    ++count;
    sum += glm::dvec2(cx, cy);
    if (cx > 0) todo.emplace_back(cx - 1, cy);
    if (cy > 0) todo.emplace_back(cx, cy - 1);
    if (cx + 1 < rows[cy].size()) todo.emplace_back(cx + 1, cy);
    if (cy + 1 < rows.size()) todo.emplace_back(cx, cy + 1);
  }
  return count;
}

}  // namespace

TEST_CASE(
    "rooms of a cave: rooms join across cell edges only, are ordered by their lowest cell, and have centre "
    "and area") {
  const sim::CaveGrid grid{{6, 4}};
  const auto rooms = sim::caveRooms(grid, cellsOf(grid, {"#..#.#", "##.##.", ".#...#", ".#####"}), 0.5F);
  REQUIRE(rooms.size() == 4);
  CHECK(rooms[0].cells == 6);  // The room has the cells (1, 0), (2, 0), (2, 1), (2, 2), (3, 2) and (4, 2).
  CHECK(rooms[0].centre.x == doctest::Approx(14.0 / 6));
  CHECK(rooms[0].centre.y == doctest::Approx(7.0 / 6));
  CHECK(rooms[0].area == doctest::Approx(1.5));
  CHECK(rooms[1].centre == glm::dvec2(4, 0));
  CHECK(rooms[2].centre == glm::dvec2(5, 1));  // This room touches another only at a corner.
  CHECK(rooms[3].cells == 2);
  CHECK(sim::caveRooms(grid, cellsOf(grid, {"######"}), 1).empty());
}

TEST_CASE("rooms of a cave: rooms equal a flood fill, across words and for every shape") {
  std::mt19937 random(5);
  for (const glm::ivec2 size :
       {glm::ivec2(1, 1), glm::ivec2(1, 70), glm::ivec2(70, 1), glm::ivec2(139, 61)})
    for (const unsigned rock : {0U, 35U, 45U, 60U, 100U}) {
      std::vector<std::string> rows(static_cast<std::size_t>(size.y));
      for (std::string& row : rows)
        for (int x = 0; x < size.x; ++x) row += random() % 100 < rock ? '#' : '.';
      const sim::CaveGrid grid{size};
      const auto rooms = sim::caveRooms(grid, cellsOf(grid, rows), 1);
      std::size_t found = 0;
      for (std::size_t y = 0; y < rows.size(); ++y)
        for (std::size_t x = 0; x < rows[y].size(); ++x) {
          if (rows[y][x] != '.') continue;
          glm::dvec2 sum(0);
          const long count = filled(rows, x, y, sum);
          REQUIRE(found < rooms.size());
          CHECK(rooms[found].cells == count);
          CHECK(rooms[found].centre.x == doctest::Approx(sum.x / static_cast<double>(count)));
          CHECK(rooms[found].centre.y == doctest::Approx(sum.y / static_cast<double>(count)));
          ++found;
        }
      CHECK(found == rooms.size());
    }
}
