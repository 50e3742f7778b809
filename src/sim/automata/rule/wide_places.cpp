#include "sim/automata/rule/notation.hpp"

#include <cstdlib>

namespace simreel::sim {

namespace {

bool counts(char letter, int range, int dx, int dy) {
  const int across = std::abs(dx), down = std::abs(dy);
  switch (letter) {
    case 'X':
      return across == down;
    case '*':
      return across == down || dx == 0 || dy == 0;
    case '#':
      return across == 1 || down == 1;
    case 'B':
      return (across + down) % 2 == 1;
    case 'D':
      return (across + down) % 2 == 0;
    case 'A':
      return dx == 0 || dy == 0 || dx == dy;
    case '3':
      return (dx == 0 && dy < 0) || (dy == 0 && dx < 0) || (dx == dy && dx > 0);
    case 'L':  // the rows next to the triangle's base, which is below the centre row, are the longest
      return across <= (dy < 0 ? 2 * range + 1 + dy : 2 * range - dy);
    default:
      return true;
  }
}

}  // namespace

std::vector<NeighbourPlace> placesOfShape(char letter, int range) {
  std::vector<NeighbourPlace> places;
  const int across = letter == 'L' ? 2 * range : range;
  for (int dy = -range; dy <= range; ++dy)
    for (int dx = -across; dx <= across; ++dx) {
      const bool middle = dx == 0 && dy == 0;
      const int weight =
          letter == 'G' ? (range + 1 - std::abs(dx)) * (range + 1 - std::abs(dy)) + (middle ? 1 : 0) : 1;
      if (middle || counts(letter, range, dx, dy)) places.push_back({dx, dy, weight});
    }
  return places;
}

}  // namespace simreel::sim
