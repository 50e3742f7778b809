#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Outer-totalistic rule on the Moore neighbourhood: bit n of a mask stands for n live neighbours.
struct LifeRule {
  int born = 1 << 3;
  int survives = 1 << 2 | 1 << 3;
  bool operator==(const LifeRule&) const = default;
  /// Returns the rule in the notation "B3/S23".
  [[nodiscard]] std::string text() const;
};

/// Neighbourhood of cells within the range r. moore: all cells; vonNeumann: |dx| + |dy| <= r; hexagonal:
/// |dx - dy| <= r (a hexagon of skewed cells); circular: dx^2 + dy^2 < (r + 1/2)^2; euclidean: dx^2 + dy^2
/// <= r^2; cross: dx = 0 or dy = 0; places: the cells of a list.
enum class NeighbourShape { moore, vonNeumann, hexagonal, circular, euclidean, cross, places };

/// Range of counts, both limits included.
struct CountRange {
  int low, high;
};

/// Offset of a counted cell from the centre cell, and the weight of the counted cell.
struct NeighbourPlace {
  int dx, dy, weight;
  bool operator==(const NeighbourPlace&) const = default;
};

/// Larger than Life (Evans 1996): the number of surrounding cells in state 1 determines the next state.
struct WideRule {
  int range = 1;
  bool middle = false;  ///< true if the centre cell is counted, too
  std::vector<CountRange> survive{{2, 3}}, born{{3, 3}};
  NeighbourShape shape = NeighbourShape::moore;
  std::vector<NeighbourPlace> places;  ///< used only for the shape `places`; includes the centre
  bool flips = false;                  ///< true if dy is negated in cells with odd x + y (triangular grid)
  std::vector<int> stateWeights;       ///< weight of each state; if empty, only state 1 counts, with weight
                                       ///< 1
  /// First and last column of the neighbours in a row, relative to the centre; none exist if first >
  /// last.
  struct Span {
    int first, last;
  };
  [[nodiscard]] Span span(int dy) const;
  /// Returns the maximum possible count, including the centre.
  [[nodiscard]] int maximum() const;
};

/// Cyclic automaton (Griffeath 1988): a cell advances to the next state (0 after the last) if at least
/// `threshold` of its neighbours have that state.
struct CyclicRule {
  int range = 1, threshold = 1;
  NeighbourShape shape = NeighbourShape::moore;
};

/// Transition function as a decision diagram. Each level of nodes branches on the state of one neighbour,
/// in the order of Golly's rule trees: north-west, north-east, south-west, south-east, north, west, east,
/// south, centre; with four neighbours: north, west, east, south, centre. The item at the index node +
/// state is the index of the next node or, at the last level, the new state.
struct RuleTree {
  int neighbours = 8;  ///< number of neighbours: 8 or 4
  std::uint32_t root = 0;
  std::vector<std::uint32_t> items;
};

/// Rule of an automaton of any supported family.
struct CellRule {
  /// counts: a LifeRule. map: any function of the cell and its eight neighbours, each of which is alive
  /// (state 1) or not. With more than two states, cells that do not survive age through the remaining
  /// states (Generations).
  enum class Family { counts, map, wide, cyclic, tree };
  Family family = Family::counts;
  int states = 2;
  LifeRule counts;
  /// For the family map: bit i is the next state of a cell with the neighbourhood i. Bit k of i is cell k
  /// of the nine, row by row from the upper left; k = 4 is the cell itself.
  std::array<std::uint32_t, 16> map{};
  WideRule wide;
  CyclicRule cyclic;
  std::shared_ptr<const RuleTree> tree;
  std::vector<glm::vec3> colors;  ///< linear RGB colour of each state; empty if the rule file defines no
                                  ///< colours
  std::string name;               ///< notation of the rule, for all families except counts

  CellRule() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): every LifeRule is a CellRule
  CellRule(const LifeRule& rule) : counts(rule) {}
  bool operator==(const CellRule& other) const {
    return family == other.family && states == other.states && text() == other.text();
  }
  [[nodiscard]] std::string text() const { return family == Family::counts ? counts.text() : name; }
  /// Returns the distance of the farthest cells that affect a cell's next state.
  [[nodiscard]] int range() const;
  /// Returns true if the centre of nine cells (bits as in `map`) is alive in the next state, for the
  /// families counts and map.
  [[nodiscard]] bool outcome(unsigned neighbourhood) const;
  /// Returns true if the rule can be computed on bits (glsl/life), that is, if it has two states and
  /// depends only on the cell and its eight neighbours.
  [[nodiscard]] bool onBits() const {
    return states == 2 && (family == Family::counts || family == Family::map);
  }
};

/// Error of a parser, with the zero-based position in the text.
struct RuleProblem {
  std::size_t at = 0;
  std::string message;  ///< error message; empty if there is no error
};

/// Parses a rule in the notations of Golly and MCell:
///   B3/S23, 23/3         neighbour counts for birth and survival, of eight; letters of either case
///   B2-a/S12             a count may have letters of arrangements (Hensel's isotropic notation)
///   B2/S013V, B2/S34H    four neighbours (von Neumann), six (hexagonal)
///   MAP...               512, 128 or 32 bits in base64: one for every neighbourhood
///   /2/3, B2/S/C3        Generations: the last number is the number of states; also with
///                        letters, V, H and MAP
///   W110                 one of Wolfram's one-dimensional rules (even ones): living cells stay alive,
///                        and the three cells above determine whether a cell is born
///   R5,C0,M1,S34..58,B34..45,NM    Larger than Life; also 5,34,45,34,58
///   R2,C0,S2-3,8,B3,12-14,NN       Larger than Life with lists of counts; NM may be omitted
///                        NN von Neumann, NC circular, N2 Euclidean, N+ cross, NX saltire, N* star,
///                        N# hash, NB and ND checkerboards, NH hexagonal, NA asterisk, N3 tripod, NL
///                        triangular, NG Gaussian; N@ and hexadecimal digits: one bit per cell; NW:
///                        weights of cells, then optionally ",012A": weights of states
///   R1/T3/C3/NM          cyclic: range, threshold, states, neighbourhood
///   JvN29, Nobili32, Hutton32      signals on wires (signal_rules.hpp)
/// and the names of rulePresets().
[[nodiscard]] RuleProblem parseCellRule(std::string_view text, CellRule& rule);

/// Returns true if a text that is not a rule notation may be the name of a rule that a file NAME.rule
/// defines.
[[nodiscard]] bool isRuleName(std::string_view text);

/// Rule with a name.
struct RulePreset {
  const char* name;
  const char* rule;
  const char* doc;
};
[[nodiscard]] const std::vector<RulePreset>& rulePresets();

}  // namespace simreel::sim
