#include "reference/cave_twin.hpp"

#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/cave/corridor.glsl"
}
#undef precise
#undef FUNCTION

using namespace simreel;

CaveTwin::CaveTwin(const sim::CaveParameters& parameters, int seed)
    : parameters_(parameters), seed_(seed), size_(parameters.size) {
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const bool border = x == 0 || y == 0 || x == size_.x - 1 || y == size_.y - 1;
      const glm::uvec3 hash = shader::hash3(glm::uvec3(x, y, seed));
      rock.push_back(border || hash.x < parameters.threshold());
    }
}

void CaveTwin::smooth() {
  std::vector<bool> next(rock.size(), true);
  for (int y = 1; y < size_.y - 1; ++y)
    for (int x = 1; x < size_.x - 1; ++x) {
      int around = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) around += isRock(x + dx, y + dy) ? 1 : 0;
      next[index(x, y)] = around >= 5;
    }
  rock = next;
}

std::vector<float> CaveTwin::blended(const std::vector<bool>& before, float fraction) const {
  const auto wasRock = [&](int x, int y) {
    return x < 0 || y < 0 || x >= size_.x || y >= size_.y || before[index(x, y)];
  };
  std::vector<float> values;
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      const bool now = rock[index(x, y)];
      if (wasRock(x, y) == now) {
        values.push_back(now ? 1.0F : 0.0F);
        continue;
      }
      unsigned likeNow = 0;  // The cell itself is not counted, because it was of the other kind.
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) likeNow += wasRock(x + dx, y + dy) == now ? 1 : 0;
      const unsigned chance = (shader::hash3(glm::uvec3(x, y, seed_)).y >> 16U) % 193U;
      const float turn = static_cast<float>(544U - 32U * likeNow + chance) / 1024.0F;
      const float since = 2.0F * (fraction - turn);
      values.push_back(std::clamp(now ? 0.5F + since : 0.5F - since, 0.0F, 1.0F));
    }
  return values;
}

std::vector<int> CaveTwin::regions(bool ofRock) const {
  std::vector<int> found(rock.size(), -1);
  for (std::size_t first = 0; first < rock.size(); ++first) {
    if (rock[first] != ofRock || found[first] >= 0) continue;
    std::vector<std::size_t> queue = {first};
    found[first] = static_cast<int>(first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int x = static_cast<int>(queue[i] % static_cast<std::size_t>(size_.x));
      const int y = static_cast<int>(queue[i] / static_cast<std::size_t>(size_.x));
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (!ofRock && dx != 0 && dy != 0) continue;
          const int nx = x + dx;
          const int ny = y + dy;
          if (nx < 0 || ny < 0 || nx >= size_.x || ny >= size_.y) continue;
          const std::size_t next = index(nx, ny);
          if (rock[next] != ofRock || found[next] >= 0) continue;
          found[next] = static_cast<int>(first);
          queue.push_back(next);
        }
    }
  }
  return found;
}

void CaveTwin::remove(bool ofRock, int fewest) {
  const std::vector<int> region = regions(ofRock);
  std::map<int, int> cells;
  for (const int r : region)
    if (r >= 0) ++cells[r];
  int kept = 0;
  if (!ofRock)
    for (const auto& [r, count] : cells)
      if (kept == 0 || count > cells[kept]) kept = r;
  for (std::size_t i = 0; i < rock.size(); ++i)
    if (region[i] >= 0 && region[i] != kept && cells[region[i]] < fewest) rock[i] = !ofRock;
}

void CaveTwin::clean() {
  remove(false, parameters_.smallestRoom);
  remove(true, parameters_.smallestRock);
}

/// Returns the index of the nearest open cell for each cell, found by breadth-first search from all open
/// cells. If several open cells are equally near, returns the one with the lowest index.
std::vector<int> CaveTwin::nearestOpen() const {
  std::vector<int> source(rock.size(), -1);
  std::vector<std::size_t> wave;
  for (std::size_t i = 0; i < rock.size(); ++i)
    if (!rock[i]) {
      source[i] = static_cast<int>(i);
      wave.push_back(i);
    }
  while (!wave.empty()) {
    std::map<std::size_t, int> reached;
    for (const std::size_t i : wave) {
      const int x = static_cast<int>(i % static_cast<std::size_t>(size_.x));
      const int y = static_cast<int>(i / static_cast<std::size_t>(size_.x));
      const glm::ivec2 ways[] = {{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}};
      for (const glm::ivec2 at : ways) {
        if (at.x < 0 || at.y < 0 || at.x >= size_.x || at.y >= size_.y) continue;
        const std::size_t next = index(at.x, at.y);
        if (source[next] >= 0) continue;
        const auto known = reached.find(next);
        if (known == reached.end() || known->second > source[i]) reached[next] = source[i];
      }
    }
    wave.clear();
    for (const auto& [cell, from] : reached) {
      source[cell] = from;
      wave.push_back(cell);
    }
  }
  return source;
}

/// Returns the corridors of Kruskal's spanning tree. The edges of the graph are the paths across each
/// border between two cells, sorted by length, then by the border's index.
std::vector<CaveTwin::Corridor> CaveTwin::corridors() const {
  std::vector<Corridor> dug;
  const std::vector<int> room = regions(false);
  const std::vector<int> source = nearestOpen();
  if (source.empty() || source[0] < 0) return dug;
  struct Way {
    long length;
    std::size_t edge;
    int from, to;
  };
  std::vector<Way> ways;
  const auto placeOf = [&](int cell) { return glm::ivec2(cell % size_.x, cell / size_.x); };
  const auto steps = [](glm::ivec2 a, glm::ivec2 b) {
    return static_cast<long>(std::abs(a.x - b.x)) + std::abs(a.y - b.y);
  };
  const auto consider = [&](glm::ivec2 here, glm::ivec2 next, std::size_t down) {
    if (next.x >= size_.x || next.y >= size_.y) return;
    const int from = source[index(here.x, here.y)];
    const int to = source[index(next.x, next.y)];
    if (room[static_cast<std::size_t>(from)] == room[static_cast<std::size_t>(to)]) return;
    ways.push_back({steps(placeOf(from), here) + steps(placeOf(to), next) + 1,
                    2 * index(here.x, here.y) + down, from, to});
  };
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < size_.x; ++x) {
      consider({x, y}, {x + 1, y}, 0);
      consider({x, y}, {x, y + 1}, 1);
    }
  std::sort(ways.begin(), ways.end(), [](const Way& a, const Way& b) {
    return std::pair(a.length, a.edge) < std::pair(b.length, b.edge);
  });
  std::vector<int> tree(rock.size());
  std::iota(tree.begin(), tree.end(), 0);
  const auto rootOf = [&](int cell) {
    while (tree[static_cast<std::size_t>(cell)] != cell) cell = tree[static_cast<std::size_t>(cell)];
    return cell;
  };
  for (const Way& way : ways) {
    const int a = rootOf(room[static_cast<std::size_t>(way.from)]);
    const int b = rootOf(room[static_cast<std::size_t>(way.to)]);
    if (a == b) continue;
    tree[static_cast<std::size_t>(a)] = b;
    dug.push_back({way.length, placeOf(way.from), placeOf(way.to)});
  }
  return dug;
}

long CaveTwin::corridorLength() const {
  long sum = 0;
  for (const Corridor& corridor : corridors()) sum += corridor.length;
  return sum;
}

void CaveTwin::dig(const Corridor& corridor) {
  const glm::ivec2 way = corridor.to - corridor.from;
  const glm::ivec2 amount(std::abs(way.x), std::abs(way.y));
  const bool wide = amount.x >= amount.y;
  const int longer = std::max(amount.x, amount.y);
  for (int along = 0; along <= longer; ++along) {
    const shader::CorridorCells c =
        shader::corridorCells(along, longer, std::min(amount.x, amount.y), parameters_.corridor);
    for (int across = c.first; across <= c.last; ++across) {
      const int dx = (wide ? along : across) * (way.x < 0 ? -1 : 1);
      const int dy = (wide ? across : along) * (way.y < 0 ? -1 : 1);
      const glm::ivec2 at = corridor.from + glm::ivec2(dx, dy);
      if (at.x < 1 || at.y < 1 || at.x >= size_.x - 1 || at.y >= size_.y - 1) continue;
      rock[index(at.x, at.y)] = false;
    }
  }
}

void CaveTwin::connect() {
  if (!parameters_.connect) return;
  for (const Corridor& corridor : corridors()) dig(corridor);
}

void CaveTwin::finish() {
  for (int i = 0; i < parameters_.smoothing; ++i) smooth();
  clean();
  connect();
}

std::vector<int> CaveTwin::distancesFrom(glm::ivec2 start) const {
  std::vector<int> steps(rock.size(), -1);
  std::vector<glm::ivec2> queue = {start};
  steps[index(start.x, start.y)] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const glm::ivec2 at = queue[i];
    for (const glm::ivec2 way :
         {glm::ivec2(-1, 0), glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(0, 1)}) {
      const glm::ivec2 next = at + way;
      if (isRock(next.x, next.y) || steps[index(next.x, next.y)] >= 0) continue;
      steps[index(next.x, next.y)] = steps[index(at.x, at.y)] + 1;
      queue.push_back(next);
    }
  }
  return steps;
}

glm::ivec2 CaveTwin::farthest(const std::vector<int>& distances) const {
  const auto found = std::max_element(distances.begin(), distances.end());  // max_element() returns the
                                                                            // first of equal maxima.
  const int cell = static_cast<int>(found - distances.begin());
  return {cell % size_.x, cell / size_.x};
}

std::optional<std::pair<glm::ivec2, glm::ivec2>> CaveTwin::ends() const {
  const std::vector<int> region = regions(false);
  std::map<int, int> cells;
  for (const int r : region)
    if (r >= 0) ++cells[r];
  if (cells.empty()) return std::nullopt;
  const auto largest = std::max_element(cells.begin(), cells.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
  const glm::ivec2 first(largest->first % size_.x, largest->first / size_.x);
  const glm::ivec2 entrance = farthest(distancesFrom(first));
  return std::pair(entrance, farthest(distancesFrom(entrance)));
}

std::vector<glm::uvec4> CaveTwin::words() const {
  const int rowWords = (size_.x + 127) / 128 * 4;
  std::vector<glm::uvec4> elements(
      static_cast<std::size_t>(rowWords / 4) * static_cast<std::size_t>(size_.y), glm::uvec4(0));
  for (int y = 0; y < size_.y; ++y)
    for (int x = 0; x < 32 * rowWords; ++x) {
      if (x < size_.x && !isRock(x, y)) continue;
      const int word = y * rowWords + x / 32;
      elements[static_cast<std::size_t>(word / 4)][word % 4] |= 1U << static_cast<unsigned>(x % 32);
    }
  return elements;
}
