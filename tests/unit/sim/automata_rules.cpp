// Tests the notations of automaton rules, and the rules that they describe.
#include "reference/states_twin.hpp"
#include "sim/automata/file/rule_file.hpp"
#include "sim/automata/rule/arrangements.hpp"
#include "sim/automata/rule/cell_rule.hpp"
#include "sim/automata/rule/signal_rules.hpp"
#include "unit/help.hpp"
#include "unit/sim/notation_help.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
using simreel::test::checkHas;
using simreel::test::written;
using namespace simreel::sim;

namespace {

CellRule ruleOf(std::string_view text) {
  CellRule rule;
  CHECK(parseCellRule(text, rule).message.empty());
  return rule;
}

std::string fileMistake(std::string_view text) {
  return test::mistakeIn([&] { return parseRuleFile(text, "r.rule"); });
}

}  // namespace

TEST_CASE("nine cells have 102 arrangements up to symmetry, 51 without the centre") {
  std::set<std::pair<int, int>> all;
  int cells[9][13] = {};
  for (unsigned i = 0; i < 512; ++i) {
    const Arrangement a = arrangementOf(i);
    all.insert({a.count, a.letter});
    ++cells[a.count][a.letter];
    CHECK((lettersOf(a.count) >> a.letter & 1) == 1);
  }
  CHECK(all.size() == 51);
  // By Burnside's lemma for the eight symmetries of the square, there are 102 classes. Each contains 1, 2,
  // 4 or 8 patterns. `cells` counts each pattern twice, with and without the centre.
  for (const auto& [count, letter] : all) CHECK(16 % cells[count][letter] == 0);
}

TEST_CASE("rules are written in Golly's notation") {
  CHECK(written("B2cekin/S12") == "B2-a/S12");
  CHECK(written("B2-a/S12") == "B2-a/S12");
  CHECK(written("b2nic/s") == "B2cin/S");
  CHECK(written("B2ceikn/S") == "B2-a/S");
  CHECK(written("B4-qjrtwz/S") == "B4aceikny/S");
  CHECK(written("B2aceikn3/S") == "B23/S");
  CHECK(written("B2-3/S8") == "B23/S8");
  CHECK(written("B2-aceikn3/S") == "B3/S");
  CHECK(written("B3_S23") == "B3/S23");
  CHECK(written("2-n3/3") == "B3/S2-n3");
  CHECK(written("B2/S013v") == "B2/S013V");
  CHECK(written("B2/S34H") == "B2/S34H");
  CHECK(written("/2/3") == "/2/3");
  CHECK(written("B2/S345/C4") == "345/2/4");
  CHECK(written("B2/S345/4") == "345/2/4");
  CHECK(written("23/3/2") == "B3/S23");
  CHECK(written("2/13/21V") == "2/13/21V");
  CHECK(written("2-a/3n/8") == "2-a/3n/8");
  CHECK(written("r5,c0,m1,s34..58,b34..45,nm") == "R5,C0,M1,S34..58,B34..45,NM");
  CHECK(written("5,34,45,34,58") == "R5,C0,M1,S34..58,B34..45,NM");
  CHECK(written("R1/T3/C3/NM") == "R1/T3/C3/NM");
  CHECK(written("r1,c2,s2-3,b3,nm") == "R1,C0,S2-3,B3");
  CHECK(written("R2,C0,S8,3-4,2,4-5,B3,10-12,NN") == "R2,C0,S2-5,8,B3,10-12,NN");
  CHECK(written("R2,C3,S,B3,N+") == "R2,C3,S,B3,N+");
  CHECK(written("R3,C0,M0,S2..3,B3..4,NL") == "R3,C0,M0,S2..3,B3..4,NL");
  CHECK(written("R1,C0,S3,B3,Nw12340a323H") == "R1,C0,S3,B3,NW12340A323H");
  CHECK(written("W110") == "W110");
  CHECK(written("Brian's Brain") == "/2/3");
  CHECK(written("bosco") == "R5,C0,M1,S34..58,B34..45,NM");
  CHECK(written("313") == "R1/T3/C3/NM");
}

TEST_CASE("every preset is a valid rule") {
  for (const RulePreset& preset : rulePresets()) {
    CAPTURE(preset.name);
    const std::string rule = written(preset.rule);
    CHECK(rule.find(": ") == std::string::npos);
    CHECK(written(preset.name) == rule);
  }
}

TEST_CASE("rules of signals: the diagram equals the rule in random neighbourhoods") {
  std::mt19937 random(5);
  for (const auto& [name, kind] : {std::pair("JvN29", sim::SignalRule::jvn29),
                                   {"Nobili32", sim::SignalRule::nobili32},
                                   {"Hutton32", sim::SignalRule::hutton32}}) {
    sim::CellRule rule;
    REQUIRE(sim::parseCellRule(name, rule).message.empty());
    CHECK(rule.states == sim::statesOf(kind));
    CHECK(rule.colors.size() == static_cast<std::size_t>(rule.states));
    int wrong = 0;
    for (int i = 0; i < 50000; ++i) {
      const auto state = [&] { return static_cast<int>(random() % static_cast<unsigned>(rule.states)); };
      const std::array<int, 4> around = {state(), state(), state(), state()};
      const int middle = state();
      std::uint32_t at = rule.tree->root;
      for (const int next : {around[1], around[2], around[0], around[3], middle})
        at = rule.tree->items[at + static_cast<std::uint32_t>(next)];
      wrong += static_cast<int>(at) == sim::signalOutcome(kind, middle, around) ? 0 : 1;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("rules of signals: bits write each cell of von Neumann's, and crossed wires keep their signals") {
  using sim::SignalRule;
  const auto cellAfter = [](const std::vector<int>& bits) {
    int cell = 0;
    for (const int bit : bits)
      cell = sim::signalOutcome(SignalRule::jvn29, cell, {0, 0, bit == 1 ? 13 : 9, 0});
    return cell;
  };
  CHECK(cellAfter({1, 0, 0, 0, 0}) == 9);
  CHECK(cellAfter({1, 0, 0, 0, 1}) == 10);
  CHECK(cellAfter({1, 0, 0, 1}) == 11);
  CHECK(cellAfter({1, 1, 1, 1}) == 25);
  CHECK(cellAfter({1, 1, 1, 0}) == 20);
  // Signals enter from the west and south and leave to the east and north.
  CHECK(sim::signalOutcome(SignalRule::nobili32, 25, {9, 10, 13, 14}) == 31);
  CHECK(sim::signalOutcome(SignalRule::nobili32, 25, {9, 10, 13, 10}) == 29);
  CHECK(sim::signalOutcome(SignalRule::nobili32, 29, {9, 10, 9, 14}) == 30);
  CHECK(sim::signalOutcome(SignalRule::nobili32, 9, {0, 0, 29, 0}) == 13);
  CHECK(sim::signalOutcome(SignalRule::nobili32, 9, {0, 0, 30, 0}) == 9);
}

TEST_CASE("MAP rules equal the letter notation") {
  const CellRule life =
      ruleOf("MAPARYXfhZofugWaH7oaIDogBZofuhogOiAaIDogIAAgAAWaH7oaIDogGiA6ICAAIAAaIDogIAAgACAAIAAAAAAAA==");
  for (unsigned i = 0; i < 512; ++i) CHECK(life.outcome(i) == CellRule().outcome(i));
  CHECK(ruleOf("MAPARYXfg/7").states == 7);
  // In both rules only the highest bits are set. In the first rule, a cell becomes alive if only its lower
  // neighbour lives (hexagonal neighbourhood). In the second, it becomes alive if only its upper neighbour
  // lives (four neighbours).
  const CellRule below = ruleOf("MAPAAAAAAAAAAD//////////w"), above = ruleOf("MAPAAD//w");
  for (unsigned cell = 0; cell < 9; ++cell) {
    CHECK(below.outcome(1U << cell) == (cell == 7));
    CHECK(above.outcome(1U << cell) == (cell == 1));
  }
}

TEST_CASE("invalid rules of every family are refused at their position") {
  checkHas(written("B1a/S"), "2: there is no arrangement a of 1 neighbours; its letters are ce");
  checkHas(written("B5z/S"), "2: there is no arrangement z of 5");
  checkHas(written("B2cc/S"), "3: the letter c occurs twice");
  checkHas(written("B8c/S"), "2: 8 neighbours have only one arrangement");
  checkHas(written("B2c/S1V"), "2: letters describe the arrangement of eight");
  checkHas(written("B5/S1V"), "1: a cell has 4 neighbours with V, not 5");
  checkHas(written("B7/S1H"), "1: a cell has 6 neighbours with H, not 7");
  checkHas(written("B2/S/1"), "5: the number of states is 1 here; it goes from 2 to 256");
  checkHas(written("/2/300"), "3: the number of states is 300");
  checkHas(written("/2/"), "3: the number of states is missing");
  checkHas(written("/2/3x"), "4: 'x' after the number of states");
  checkHas(written("R5,C0,M1,S34..58,B34..45"), "at the end; Larger than Life is written as");
  checkHas(written("R5,C0,M1,S58..34,B34..45,NM"), "10: 58 to 34: the lower limit is above the upper");
  checkHas(written("R5,C0,M1,S34..580,B34..45,NM"), "14: a limit of S is 580 here; it goes from 0 to 121");
  checkHas(written("R0,C0,M1,S3..5,B3..4,NM"), "1: the range is 0");
  checkHas(written("R501,C0,M1,S3..5,B3..4,NC"), "1: the range is 501 here; it goes from 1 to 500");
  checkHas(written("R5,C300,M1,S3..5,B3..4,NM"), "4: the number of states is 300");
  checkHas(written("R5,C0,M1,S3..5,B3..4,NZ"), "22: the neighbourhood is M");
  checkHas(written("R5,C0,M1,S3..58,B3..4,NX"), "13: a limit of S is 58 here; it goes from 0 to 21");
  checkHas(written("R1,C0,S2-3,B9"), "12: a count of B is 9 here; it goes from 0 to 8");
  checkHas(written("R1,C0,S3-2,B3"), "7: 3 to 2: the lower limit");
  checkHas(written("R1,C0,S3,x"), "9: 'B' is expected here");
  checkHas(written("R251,C0,S3,B3,NL"), "15: the range of this neighbourhood is 250");
  checkHas(written("R51,C0,S3,B3,NG"), "14: the range of this neighbourhood is 50");
  checkHas(written("R200,C0,S3,B3,NB"),
           "15: of this range this neighbourhood has 80401 cells; there may be 60000");
  checkHas(written("R2,C0,S3,B3,N@89189"),
           "14: found 5 hexadecimal digits, but 6 are needed to say which of the 24 cells");
  checkHas(written("R1,C0,S3,B3,NW12340132"),
           "14: found 8 hexadecimal digits, but 9 or 18 are needed for the weights");
  checkHas(written("R1,C3,S3,B3,NW123401323,01"),
           "24: found 2 weights of states, but the rule has 3 states");
  checkHas(written("W31"), "1: 31 is odd");
  checkHas(written("W256"), "1: the rule's number is 256 here; it goes from 0 to 255");
  checkHas(written("W30x"), "3: 'x' after the end");
  checkHas(written("R1/T9/C3/NM"), "4: the threshold is 9 here; it goes from 1 to 8");
  checkHas(written("R1/T3/C1/NM"), "7: the number of states is 1");
  checkHas(written("MAPAB?"), "5: '?' is not a digit of base64");
  checkHas(written("B3/S23:T30,20"), "6: a rule in a scene cannot name a grid");
  checkHas(written("MAPABC"), "3: MAP is followed by 86, 22");
}

TEST_CASE("circular Larger than Life neighbourhoods contain the points nearer than range + 1/2") {
  for (int range = 1; range <= 500; range += 1 + range / 20) {
    WideRule rule;
    rule.range = range;
    rule.shape = NeighbourShape::circular;
    for (int dy = -range; dy <= range; ++dy) {
      const int dx = rule.span(dy).last;
      const auto inside = [&](int x) { return x * x + dy * dy < (range + 0.5) * (range + 0.5); };
      CHECK(inside(dx));
      CHECK_FALSE(inside(dx + 1));
    }
  }
}

TEST_CASE("neighbourhoods of range 2 equal the drawings in Golly's help") {
  const auto drawn = [](const char* letter) {
    const WideRule rule = ruleOf((std::string("R2,C0,S3,B3,N") + letter).c_str()).wide;
    std::string cells;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const auto here = [&](const NeighbourPlace& p) { return p.dx == dx && p.dy == dy; };
        const auto [first, last] = rule.span(dy);
        cells += (rule.shape == NeighbourShape::places ? std::ranges::any_of(rule.places, here)
                                                       : first <= dx && dx <= last)
                     ? '#'
                     : '.';
      }
    return cells;
  };
  CHECK(drawn("2") == "..#...###.#####.###...#..");
  CHECK(drawn("+") == "..#....#..#####..#....#..");
  CHECK(drawn("X") == "#...#.#.#...#...#.#.#...#");
  CHECK(drawn("*") == "#.#.#.###.#####.###.#.#.#");
  CHECK(drawn("#") == ".#.#.#####.###.#####.#.#.");
  CHECK(drawn("B") == ".#.#.#.#.#.###.#.#.#.#.#.");
  CHECK(drawn("D") == "#.#.#.#.#.#.#.#.#.#.#.#.#");
  CHECK(drawn("H") == "###..####.#####.####..###");
  CHECK(drawn("A") == "#.#...##..#####..##...#.#");
  CHECK(drawn("3") == "..#....#..###.....#.....#");
  CHECK(drawn("@891891") == "#...#..#...###...#..#...#");
}

TEST_CASE("a rule table with variables and symmetries gives the expected states") {
  // A signal of state 2 moves along a wire of state 1. It leaves state 3 behind, which becomes wire again.
  // The rule is rotationally symmetric.
  const CellRule rule = parseRuleFile(
      "@RULE Signal\n\n@TABLE\n# comment\nn_states:4\nneighborhood:vonNeumann\nsymmetries:rotate4\n"
      "var a={0,1,2,3}\nvar b={a}\nvar c={0,1,3}\nvar d={0,1,2,3}\n1,2,a,b,d,2\n2,a,b,c,d,3\n3,a,b,c,d,1\n"
      "@COLORS\n0 0 0 0\n1 255 255 255 copper\n",
      "r.rule");
  CHECK(rule.states == 4);
  CHECK(rule.name == "Signal");
  REQUIRE(rule.colors.size() == 4);
  CHECK(rule.colors[1].x == doctest::Approx(1).epsilon(1e-6));
  std::vector<std::uint8_t> cells = {0, 0, 0, 0, 0, 3, 2, 1, 1, 1, 0, 0, 0, 0, 0};
  cells = nextStates(cells, {5, 3}, rule, {});
  CHECK(cells == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 3, 2, 1, 1, 0, 0, 0, 0, 0});
  cells = nextStates(cells, {5, 3}, rule, {});
  CHECK(cells == std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 1, 3, 2, 1, 0, 0, 0, 0, 0});
}

TEST_CASE("Life written as a rule table with permuted neighbours and as a tree equals Life") {
  const CellRule table = parseRuleFile(
      "@RULE L\n@TABLE\nn_states:2\nneighborhood:Moore\nsymmetries:permute\nvar a={0,1}\nvar b={0,1}\nvar "
      "c={0,1}\nvar d={0,1}\nvar e={0,1}\nvar f={0,1}\nvar g={0,1}\nvar h={0,1}\n0,1,1,1,0,0,0,0,0,1\n"
      "1,1,1,0,0,0,0,0,0,1\n1,1,1,1,0,0,0,0,0,1\n1,a,b,c,d,e,f,g,h,0\n",
      "r.rule");
  std::string tree = "@RULE T\n@TREE\nnum_states=2\nnum_neighbors=8\n";
  // The tree has a node for each depth and each number of living cells counted so far. The nodes are
  // written from depth 1 up.
  std::string nodes;
  int made = 0;
  int at[10][9] = {};
  for (int depth = 1; depth <= 9; ++depth)
    for (int count = 0; count <= 9 - depth; ++count) {
      at[depth][count] = made++;
      nodes += std::to_string(depth) + " ";
      if (depth == 1)
        nodes += std::string(count == 3 ? "1" : "0") + " " + (count == 2 || count == 3 ? "1" : "0") + "\n";
      else
        nodes +=
            std::to_string(at[depth - 1][count]) + " " + std::to_string(at[depth - 1][count + 1]) + "\n";
    }
  tree += "num_nodes=" + std::to_string(made) + "\n" + nodes;
  const CellRule counted = parseRuleFile(tree, "t.rule");
  std::vector<std::uint8_t> a, b, c;
  for (unsigned i = 0; i < 41 * 23; ++i) a.push_back(i * 2654435761U % 97 < 35 ? 1 : 0);
  b = c = a;
  for (int i = 0; i < 30; ++i) {
    a = nextStates(a, {41, 23}, LifeRule{}, {});
    b = nextStates(b, {41, 23}, table, {});
    c = nextStates(c, {41, 23}, counted, {});
    REQUIRE(a == b);
    REQUIRE(a == c);
  }
}

TEST_CASE("cyclic rules equal their rule tables") {
  const auto table = [](int states, int threshold, bool four) {
    std::string text = "@RULE C\n@TABLE\nn_states:" + std::to_string(states) +
                       "\nneighborhood:" + (four ? "vonNeumann" : "Moore") + "\nsymmetries:permute\n";
    const int neighbours = four ? 4 : 8;
    std::string all = "0";
    for (int s = 1; s < states; ++s) all += "," + std::to_string(s);
    for (int i = 0; i < neighbours; ++i) text += "var v" + std::to_string(i) + "={" + all + "}\n";
    for (int s = 0; s < states; ++s) {
      const std::string next = std::to_string((s + 1) % states);
      text += std::to_string(s);
      for (int i = 0; i < neighbours; ++i) text += "," + (i < threshold ? next : "v" + std::to_string(i));
      text += "," + next + "\n";
    }
    return parseRuleFile(text, "c.rule");
  };
  const glm::ivec2 size(37, 26);
  const std::pair<const char*, CellRule> both[] = {{"R1/T1/C4/NN", table(4, 1, true)},
                                                   {"R1/T3/C3/NM", table(3, 3, false)},
                                                   {"R1/T2/C5/NM", table(5, 2, false)}};
  for (const auto& item : both) {
    const char* name = item.first;
    const CellRule& rule = item.second;
    CAPTURE(name);
    std::vector<std::uint8_t> cells;
    for (unsigned i = 0; i < 37 * 26; ++i)
      cells.push_back(
          static_cast<std::uint8_t>((i * 2654435761U >> 16) % static_cast<unsigned>(rule.states)));
    auto other = cells;
    const auto start = cells;
    for (int i = 0; i < 20; ++i) {
      cells = nextStates(cells, size, ruleOf(name), {});
      other = nextStates(other, size, rule, {});
      REQUIRE(cells == other);
    }
    CHECK(cells != start);
  }
}

TEST_CASE("invalid rule files are refused at their position") {
  const std::string head = "@RULE X\n@TABLE\nn_states:3\nneighborhood:vonNeumann\nsymmetries:rotate4\n";
  checkHas(fileMistake("x = 3, y = 3\n"), "r.rule: this is not a rule file");
  checkHas(fileMistake("@RULE X\n@COLORS\n"), "neither @TABLE nor @TREE");
  checkHas(fileMistake("@RULE X\n@TABLE\n"), "lacks \"n_states:\"");
  checkHas(fileMistake("@RULE X\n@TABLE\nn_states:1\n"), "r.rule:3:10: a rule has at least 2 states");
  checkHas(fileMistake("@RULE X\n@TABLE\n0,1,2\n"), "r.rule:3:1: \"n_states:\" must come before this");
  checkHas(fileMistake("@RULE X\n@TABLE\nneighborhood:Margolus\n"),
           "r.rule:3:14: the neighbourhood \"Margolus\"");
  checkHas(fileMistake(head + "0,1,2,3,0,1\n"), "r.rule:6:7: a state is 3 here; it is at most 2");
  checkHas(fileMistake(head + "0,1,2,q,0,1\n"), "r.rule:6:7: \"q\" is neither a state nor a variable");
  checkHas(fileMistake(head + "0,1,2,0,1\n"), "r.rule:6:10: a transition has 6 states here");
  checkHas(fileMistake(head + "var a={1,4}\n"), "r.rule:6:10: a state is 4 here");
  checkHas(fileMistake(head + "var a=1,2\n"), "r.rule:6:1: a variable is written as");
  checkHas(fileMistake(head + "var a={1,2}\nvar b=a\n0,0,1,2,b,q\n"), "r.rule:8:11: \"q\" is neither");
  checkHas(fileMistake(head + "var a={1,2}\nvar b=c\n"), "r.rule:7:7: \"c\" is neither a state nor");
  checkHas(fileMistake(head + "var a={1,2}\n0,0,1,2,0,a\n"),
           "r.rule:7:11: the new state is the variable \"a\"");
  checkHas(fileMistake("@RULE X\n@TABLE\nn_states:3\nsymmetries:rotate8\n0,0,0,0,0,1\n"),
           "r.rule:4:12: the symmetry \"rotate8\" is not known");
  const std::string tree = "@RULE X\n@TREE\nnum_states=2\nnum_neighbors=4\nnum_nodes=5\n";
  checkHas(fileMistake(tree + "1 0 1\n"), "r.rule: @TREE ends after 1 of 5 nodes; the file may be cut off");
  checkHas(fileMistake(tree + "1 0 2\n"), "r.rule:6:5: a state is 2 here");
  checkHas(fileMistake(tree + "1 0 1\n2 0 1\n"), "r.rule:7:5: the number of a node before is 1 here");
  checkHas(fileMistake(tree + "1 0 1\n3 0 0\n"), "r.rule:7:3: node 0 has depth 1, not 2");
  checkHas(fileMistake(tree + "1 0\n"), "r.rule:6:1: a node has 3 numbers, not 2");
}
