#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// An outer-totalistic rule on the Moore neighbourhood: bit n of a mask for n living neighbours.
struct LifeRule {
  int born = 1 << 3;
  int survives = 1 << 2 | 1 << 3;
  bool operator==(const LifeRule&) const = default;
  /// As "B3/S23".
  [[nodiscard]] std::string text() const;
};

/// Which cells around one are its neighbours: all within the range r in both directions; |dx| + |dy| <= r;
/// |dx - dy| <= r, too (a hexagon of cells that lie askew); dx^2 + dy^2 < (r + 1/2)^2; dx^2 + dy^2 <= r^2;
/// dx = 0 or dy = 0; those that a list names.
enum class NeighbourShape { moore, vonNeumann, hexagonal, circular, euclidean, cross, places };

/// Counts from `low` to `high`.
struct CountRange {
  int low, high;
};

/// A cell that is counted, from the middle on, and how often.
struct NeighbourPlace {
  int dx, dy, weight;
  bool operator==(const NeighbourPlace&) const = default;
};

/// Larger than Life (Evans 1996): how many cells of state 1 lie around decides.
struct WideRule {
  int range = 1;
  bool middle = false;  ///< whether a cell counts itself
  std::vector<CountRange> survive{{2, 3}}, born{{3, 3}};
  NeighbourShape shape = NeighbourShape::moore;
  std::vector<NeighbourPlace> places;  ///< the middle among them; of shape `places` alone
  bool flips = false;                  ///< dy the other way round where x + y is odd (triangles)
  std::vector<int> stateWeights;  ///< how often cells of each state count; empty: those of state 1 once
  /// Columns from the middle's to the first and to the last of a row's neighbours; first > last: none.
  struct Span {
    int first, last;
  };
  [[nodiscard]] Span span(int dy) const;
  /// The highest count there is, that of the middle with it.
  [[nodiscard]] int most() const;
};

/// Cyclic automata (Griffeath 1988): a cell takes the next state, after the last 0, where at least
/// `threshold` of its neighbours have it.
struct CyclicRule {
  int range = 1, threshold = 1;
  NeighbourShape shape = NeighbourShape::moore;
};

/// A transition function as a decision diagram: from node to node by the states of the neighbours, in the
/// order of Golly's rule trees (north-west, north-east, south-west, south-east, north, west, east, south,
/// middle; of four: north, west, east, south, middle). Item node + state is where the next node begins, or
/// in the end the new state.
struct RuleTree {
  int neighbours = 8;  ///< or 4
  std::uint32_t root = 0;
  std::vector<std::uint32_t> items;
};

/// A rule of an automaton of any known family.
struct CellRule {
  /// counts: LifeRule. map: any function of the cell and its eight neighbours, each alive (state 1) or not;
  /// with more than two states the living that do not survive age through them (Generations).
  enum class Family { counts, map, wide, cyclic, tree };
  Family family = Family::counts;
  int states = 2;
  LifeRule counts;
  /// Of map: bit i is what becomes of a cell in the neighbourhood i, whose bit k is the cell k of nine, row
  /// by row from the upper left; k = 4 is the cell itself.
  std::array<std::uint32_t, 16> map{};
  WideRule wide;
  CyclicRule cyclic;
  std::shared_ptr<const RuleTree> tree;
  std::vector<glm::vec3> colors;  ///< linear RGB of each state, of rule files that say so; else empty
  std::string name;               ///< of all families but counts, as files write it

  CellRule() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): the plain rules are rules
  CellRule(const LifeRule& rule) : counts(rule) {}
  bool operator==(const CellRule& other) const {
    return family == other.family && states == other.states && text() == other.text();
  }
  [[nodiscard]] std::string text() const { return family == Family::counts ? counts.text() : name; }
  /// Cells beside one that its next state depends on, in each direction.
  [[nodiscard]] int range() const;
  /// What becomes of nine cells that are alive or not (bits as in `map`), of counts and map.
  [[nodiscard]] bool outcome(unsigned neighbourhood) const;
  /// Whether it may run on bits (glsl/life): two states and nothing beyond the eight neighbours.
  [[nodiscard]] bool onBits() const {
    return states == 2 && (family == Family::counts || family == Family::map);
  }
};

/// What a parser found wrong: at which character of the text, from 0.
struct RuleProblem {
  std::size_t at = 0;
  std::string message;  ///< empty: nothing
};

/// Reads a rule in the notations of Golly and of MCell:
///   B3/S23, 23/3         neighbours for birth and survival, of eight; letters of either case
///   B2-a/S12             after a number, letters of arrangements (Hensel's isotropic notation)
///   B2/S013V, B2/S34H    four neighbours (von Neumann), six (hexagonal)
///   MAP...               512, 128 or 32 bits in base64: every neighbourhood
///   /2/3, B2/S/C3        Generations: the last number counts states; also with letters, V, H and MAP
///   W110                 one of Wolfram's rules of a row (even ones): what is alive stays, and the three
///                        cells above decide whether one is born
///   R5,C0,M1,S34..58,B34..45,NM    Larger than Life; also 5,34,45,34,58
///   R2,C0,S2-3,8,B3,12-14,NN       the same with lists of counts; NM may be left out
///                        NN von Neumann, NC circular, N2 Euclidean, N+ cross, NX saltire, N* star, N#
///                        hash, NB and ND checkerboards, NH hexagonal, NA asterisk, N3 tripod, NL
///                        triangular, NG Gaussian, N@ and hexadecimal digits: a bit a cell; NW: its weight,
///                        then ",012A": those of states
///   R1/T3/C3/NM          cyclic: range, threshold, states, neighbourhood
/// and the names of rulePresets().
[[nodiscard]] RuleProblem parseCellRule(std::string_view text, CellRule& rule);

/// Whether a text that is no rule by itself may be the name of one, which a file NAME.rule explains.
[[nodiscard]] bool isRuleName(std::string_view text);

/// A rule that has a name.
struct RulePreset {
  const char* name;
  const char* rule;
  const char* doc;
};
[[nodiscard]] const std::vector<RulePreset>& rulePresets();

}  // namespace simreel::sim
