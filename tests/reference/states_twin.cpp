#include "reference/states_twin.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

using namespace simreel::sim;

namespace {

class Around {
 public:
  Around(const std::vector<std::uint8_t>& cells, glm::ivec2 size, const GridShape& shape)
      : cells_(cells), size_(size), join_(shape.join(size)) {}
  [[nodiscard]] int at(int x, int y) const {
    const int cell = simreel::shader::joinedCell(join_, x, y, size_.x);
    return cell < 0 ? 0 : cells_[static_cast<std::size_t>(cell)];
  }

 private:
  const std::vector<std::uint8_t>& cells_;
  glm::ivec2 size_;
  simreel::shader::GridJoin join_;
};

/// Returns the next state for rules in which living cells that do not survive grow older. State 0 is dead,
/// state 1 is alive, and states 2 and higher are stages of ageing.
int aged(int state, bool born, bool survives, int states) {
  if (state == 0) return born ? 1 : 0;
  if (state == 1 && survives) return 1;
  return (state + 1) % states;
}

bool near(NeighbourShape shape, int range, int dx, int dy) {
  if (shape == NeighbourShape::vonNeumann) return std::abs(dx) + std::abs(dy) <= range;
  if (shape == NeighbourShape::hexagonal) return std::abs(dx - dy) <= range;
  if (shape == NeighbourShape::euclidean) return dx * dx + dy * dy <= range * range;
  if (shape == NeighbourShape::cross) return dx == 0 || dy == 0;
  if (shape == NeighbourShape::circular) return 4 * (dx * dx + dy * dy) < (2 * range + 1) * (2 * range + 1);
  return true;
}

int nextMap(const Around& around, int x, int y, const CellRule& rule) {
  unsigned cells = 0;
  for (int k = 0; k < 9; ++k)
    if (around.at(x + k % 3 - 1, y + k / 3 - 1) == 1) cells |= 1U << k;
  const bool holds = rule.outcome(cells);
  return aged(around.at(x, y), holds, holds, rule.states);
}

bool counted(const std::vector<CountRange>& ranges, int count) {
  return std::ranges::any_of(ranges,
                             [&](const CountRange& r) { return r.low <= count && count <= r.high; });
}

int nextWide(const Around& around, int x, int y, const CellRule& rule) {
  const WideRule& wide = rule.wide;
  const auto worth = [&](int state) {
    return wide.stateWeights.empty() ? state == 1 ? 1 : 0
                                     : wide.stateWeights[static_cast<std::size_t>(state)];
  };
  const bool listed = wide.shape == NeighbourShape::places, flipped = wide.flips && (x + y) % 2 == 1;
  int count = 0;
  for (const NeighbourPlace& place : wide.places)
    count += place.weight * worth(around.at(x + place.dx, y + (flipped ? -place.dy : place.dy)));
  if (listed && !wide.middle) count -= worth(around.at(x, y));
  for (int dy = -wide.range; !listed && dy <= wide.range; ++dy)
    for (int dx = -wide.range; dx <= wide.range; ++dx)
      if (near(wide.shape, wide.range, dx, dy) && (wide.middle || dx != 0 || dy != 0))
        count += around.at(x + dx, y + dy) == 1 ? 1 : 0;
  return aged(around.at(x, y), counted(wide.born, count), counted(wide.survive, count), rule.states);
}

int nextCyclic(const Around& around, int x, int y, const CellRule& rule) {
  const CyclicRule& cyclic = rule.cyclic;
  const int state = around.at(x, y);
  const int wanted = (state + 1) % rule.states;
  int count = 0;
  for (int dy = -cyclic.range; dy <= cyclic.range; ++dy)
    for (int dx = -cyclic.range; dx <= cyclic.range; ++dx)
      if (near(cyclic.shape, cyclic.range, dx, dy)) count += around.at(x + dx, y + dy) == wanted ? 1 : 0;
  return count >= cyclic.threshold ? wanted : state;
}

int nextTree(const Around& around, int x, int y, const RuleTree& tree) {
  static constexpr glm::ivec2 eight[] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {0, -1},
                                         {-1, 0},  {1, 0},  {0, 1},  {0, 0}};
  std::uint32_t node = tree.root;
  for (int i = 8 - tree.neighbours; i < 9; ++i)
    node = tree.items[node + static_cast<std::uint32_t>(around.at(x + eight[i].x, y + eight[i].y))];
  return static_cast<int>(node);
}

}  // namespace

std::uint8_t nextState(const std::vector<std::uint8_t>& cells, glm::ivec2 size, const CellRule& rule,
                       const GridShape& shape, glm::ivec2 at) {
  const Around around(cells, size, shape);
  return static_cast<std::uint8_t>(
      rule.family == CellRule::Family::wide     ? nextWide(around, at.x, at.y, rule)
      : rule.family == CellRule::Family::cyclic ? nextCyclic(around, at.x, at.y, rule)
      : rule.family == CellRule::Family::tree   ? nextTree(around, at.x, at.y, *rule.tree)
                                                : nextMap(around, at.x, at.y, rule));
}

std::vector<std::uint8_t> nextStates(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                     const CellRule& rule, const GridShape& shape) {
  std::vector<std::uint8_t> next;
  next.reserve(cells.size());
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) next.push_back(nextState(cells, size, rule, shape, {x, y}));
  return next;
}

StatesTwin::StatesTwin(LifePlan plan, double start) : plan_(std::move(plan)) {
  const std::vector<std::uint8_t> first = plan_.firstStates();
  const glm::ivec2 size = plan_.parameters().size;
  const auto rowBytes = static_cast<std::size_t>((size.x + 15) / 16 * 16);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      cells.push_back(first[static_cast<std::size_t>(y) * rowBytes + static_cast<std::size_t>(x)]);
  paint(plan_.generationAt(plan_.frameAt(start)));
}

void StatesTwin::paint(long generation) {
  const glm::ivec2 size = plan_.parameters().size;
  for (const auto& stroke : plan_.strokesInto(generation))
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (plan_.strokes().paints(stroke, {x, y}))
          cells[static_cast<std::size_t>(y * size.x + x)] = static_cast<std::uint8_t>(stroke.value + 0.5F);
}

void StatesTwin::step(double time) {
  const long frame = plan_.frameAt(time);
  for (long g = plan_.generationAt(frame); g < plan_.generationAt(frame + 1); ++g) {
    cells = nextStates(cells, plan_.parameters().size, plan_.rule(), plan_.shape());
    paint(g + 1);
  }
}

std::vector<std::uint8_t> StatesTwin::rows() const {
  const glm::ivec2 size = plan_.parameters().size;
  const auto rowBytes = static_cast<std::size_t>((size.x + 15) / 16 * 16);
  std::vector<std::uint8_t> result(rowBytes * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < cells.size(); ++i)
    result[i / static_cast<std::size_t>(size.x) * rowBytes + i % static_cast<std::size_t>(size.x)] =
        cells[i];
  return result;
}
