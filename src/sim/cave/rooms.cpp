#include "sim/cave/rooms.hpp"

#include <algorithm>
#include <map>

namespace simreel::sim {

namespace {

/// Union-find structure, in which each set is represented by its lowest number.
class Sets {
 public:
  void add() { lower_.push_back(lower_.size()); }
  std::size_t lowestOf(std::size_t i) {
    while (lower_[i] != i) i = lower_[i] = lower_[lower_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = lowestOf(a);
    b = lowestOf(b);
    lower_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> lower_;
};

/// Horizontal run of consecutive open cells.
struct Run {
  int y, begin, end;  ///< `end` is one past the last cell.
};

std::vector<Run> runsOf(const CaveGrid& grid, const std::vector<unsigned>& cells) {
  std::vector<Run> runs;
  for (int y = 0; y < grid.size.y; ++y) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.rowWords());
    const auto isRock = [&](int x) {
      return (cells[row + static_cast<std::size_t>(x / 32)] >> static_cast<unsigned>(x % 32) & 1U) != 0;
    };
    for (int x = 0; x < grid.size.x;) {
      const int begin = x;
      while (x < grid.size.x && !isRock(x)) ++x;
      if (x > begin) runs.push_back({y, begin, x});
      while (x < grid.size.x && isRock(x)) ++x;
    }
  }
  return runs;
}

}  // namespace

std::vector<Room> caveRooms(const CaveGrid& grid, const std::vector<unsigned>& cells, float side) {
  const std::vector<Run> runs = runsOf(grid, cells);
  Sets sets;
  std::size_t above = 0;  // First run of the previous row that may touch the current run.
  for (std::size_t i = 0; i < runs.size(); ++i) {
    sets.add();
    const auto isBefore = [&](const Run& run) {
      return run.y < runs[i].y - 1 || (run.y == runs[i].y - 1 && run.end <= runs[i].begin);
    };
    while (above < i && isBefore(runs[above])) ++above;
    for (std::size_t k = above; k < i && runs[k].y < runs[i].y && runs[k].begin < runs[i].end; ++k)
      sets.join(k, i);
  }
  std::map<std::size_t, Room> rooms;  // Rooms by their lowest run, which contains the room's lowest cell.
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto [y, begin, end] = runs[i];
    Room& room = rooms[sets.lowestOf(i)];
    room.cells += end - begin;
    room.centre +=
        glm::dvec2(0.5 * (end - begin) * (begin + end - 1), static_cast<double>(y) * (end - begin));
  }
  std::vector<Room> all;
  for (auto& [lowest, room] : rooms) {
    const auto count = static_cast<double>(room.cells);
    room.centre /= count;
    room.area = count * static_cast<double>(side) * static_cast<double>(side);
    all.push_back(room);
  }
  return all;
}

}  // namespace simreel::sim
