// Tests automata as rules for a cell's next state, in volumes and on meshes, by comparison with plain
// loops.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/world/list.hpp"

#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/vec3.hpp>

using namespace simreel;

namespace {

sim::ReactionParameters automaton(const std::string& members) {
  const std::string text = "{\"version\": 1, \"objects\": {\"r\": {\"reaction\": {" + members + "}}}}";
  const auto scene = scene::parseScene(text, "s.json", {}, sim::kinds());
  return dynamic_cast<const sim::ReactionParameters&>(*scene.objects.at(0).parameters);
}

/// Rule in Bays' notation. A living cell survives if its number of living neighbours is within the survival
/// bounds. A cell is born if the number is within the birth bounds. If there are more than two states,
/// other cells that are not dead age through the states 2, 3, ... back to 0 (Generations).
struct Bays {
  int surviveLow, surviveHigh, bornLow, bornHigh, states = 2;

  [[nodiscard]] std::string rule() const {
    const std::string survives = fmt::format("{} <= n and n <= {}", surviveLow, surviveHigh);
    const std::string born = fmt::format("{} <= n and n <= {}", bornLow, bornHigh);
    const std::string dying = states == 2 ? "0" : "2";
    return fmt::format(
        R"X("lets": {{"alive": "u == 1", "n": "around(alive)"}}, "species": {{"u": {{"start": "if(random(1) > 0.3, 1, 0)",
            "next": "if(u == 0, if({}, 1, 0), if(u == 1, if({}, 1, {}), if(u == {}, 0, u + 1)))"}}}})X",
        born, survives, dying, states - 1);
  }
  [[nodiscard]] int next(int state, int neighbours) const {
    if (state == 0) return neighbours >= bornLow && neighbours <= bornHigh ? 1 : 0;
    if (state == 1 && neighbours >= surviveLow && neighbours <= surviveHigh) return 1;
    return (state + 1) % states;
  }
};

std::vector<int> plainStep(const Bays& rule, const std::vector<int>& cells, glm::ivec3 size, bool torus) {
  const auto at = [&](int x, int y, int z) {
    if (torus) {
      x = (x + size.x) % size.x;
      y = (y + size.y) % size.y;
      z = (z + size.z) % size.z;
    } else if (x < 0 || y < 0 || z < 0 || x >= size.x || y >= size.y || z >= size.z) {
      return 0;
    }
    return cells[static_cast<std::size_t>((z * size.y + y) * size.x + x)];
  };
  std::vector<int> next;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        int n = 0;
        for (int i = 0; i < 27; ++i)
          n += i != 13 && at(x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1) == 1 ? 1 : 0;
        next.push_back(rule.next(at(x, y, z), n));
      }
  return next;
}

std::vector<int> wholeNumbers(const std::vector<float>& cells) {
  return {cells.begin(), cells.end()};
}

}  // namespace

TEST_CASE("automata in a volume: Bays' rules and Generations equal a plain loop over the 26 neighbours") {
  for (const Bays& rule : {Bays{4, 5, 5, 5}, Bays{5, 7, 6, 6}, Bays{4, 5, 5, 6, 5}, Bays{2, 9, 3, 5, 3}})
    for (const bool torus : {true, false}) {
      CAPTURE(rule.surviveHigh);
      CAPTURE(torus);
      auto p = automaton(rule.rule() + (torus ? "" : ", \"boundary\": \"fixed\""));
      p.size = {13, 9};
      p.depth = 7;
      // With fixed boundaries, only a stencil applied directly to a species treats cells outside as dead. A
      // stencil over a let repeats the border cell. Rules with more than two states use such a let, so they
      // are skipped.
      if (!torus && rule.states > 2) continue;
      if (!torus) p.lets = {{"n", "around(u)"}};
      const sim::ReactionPlan plan(p, "r", 3, 1.0);
      sim::RuleField field = plan.firstField();
      std::vector<int> want = wholeNumbers(field.stage[0]);
      std::set<int> seen(want.begin(), want.end());
      for (int step = 0; step < 12; ++step) {
        sim::evaluateStep(plan, plan.valuesAt(0), step, 0, field);
        want = plainStep(rule, want, {13, 9, 7}, torus);
        seen.insert(want.begin(), want.end());
        CHECK(wholeNumbers(field.stage[0]) == want);
      }
      CHECK(static_cast<int>(seen.size()) == rule.states);
    }
}

TEST_CASE("automata on a mesh: neighbours are cells that share an edge") {
  auto p = automaton(R"X("mesh": {"shape": "torus", "resolution": [17, 12]},
    "species": {"u": {"start": "if(random(1) > 0.2, 1, 0)", "next": "if(u == 1, 2 <= n and n <= 3, n == 2)"}},
    "lets": {"n": "around(u)"})X");
  const sim::ReactionPlan plan(p, "r", 3, 1.0);
  sim::RuleField field = plan.firstField();
  std::vector<int> want = wholeNumbers(field.stage[0]);
  const sim::MeshCells& cells = plan.cells();
  CHECK(cells.count() == 16 * 11);
  for (int step = 0; step < 12; ++step) {
    sim::evaluateStep(plan, plan.valuesAt(0), step, 0, field);
    std::vector<int> next;
    for (std::size_t i = 0; i < want.size(); ++i) {
      int n = 0;
      for (int k = cells.first[i]; k < cells.first[i + 1]; ++k)
        n += want[static_cast<std::size_t>(cells.links[static_cast<std::size_t>(k)].neighbour)];
      CHECK(cells.first[i + 1] - cells.first[i] == 6);
      next.push_back(want[i] == 1 ? (n == 2 || n == 3) : n == 2);
    }
    CHECK(wholeNumbers(field.stage[0]) == next);
    CHECK(next != want);
    want = next;
  }
}

TEST_CASE("automata in a plane: Life written as an expression equals Life") {
  auto p = automaton(
      R"X("species": {"u": {"start": "if(random(1) > 0.2, 1, 0)", "next": "n == 3 or u == 1 and n == 2"}},
    "lets": {"n": "around(u)"})X");
  p.size = {4, 4};
  const sim::ReactionPlan plan(p, "r", 3, 1.0);
  sim::RuleField field = plan.firstField();
  field.stage[0] = {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0};
  const auto block = field.stage[0];
  sim::evaluateStep(plan, plan.valuesAt(0), 0, 0, field);
  CHECK(field.stage[0] == block);
  field.stage[0] = {0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  sim::evaluateStep(plan, plan.valuesAt(0), 1, 0, field);
  CHECK(field.stage[0] == std::vector<float>{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("automata: errors are reported in one line") {
  const auto refusal = [](const std::string& members) -> std::string {
    try {
      static_cast<void>(automaton(members));
      return "none";
    } catch (const UserError& error) {
      return error.what();
    }
  };
  CHECK(refusal(R"X("species": {"u": {"next": "1 - u", "rate": "u"}})X")
            .find("leave out its \"rate\" and \"diffusion\"") != std::string::npos);
  CHECK(refusal(R"X("species": {"u": {"next": "1 - u"}}, "method": "rk4")X")
            .find("works only with \"euler\"") != std::string::npos);
  CHECK(refusal(R"X("mesh": {"shape": "sphere"}, "species": {"u": {"next": "neighbours(1)"}})X")
            .find("different numbers of neighbours") != std::string::npos);
}
