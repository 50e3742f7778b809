#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <array>
#include <memory>

namespace simreel::sim {

/// Automata of signals on wires, with 29 or 32 states. The states are: 0 ground; 1 to 8 sensitized (S, S0,
/// S1, S00, S01, S10, S11, S000); 9 to 12 ordinary transmission to the east, north, west and south, 13 to
/// 16 the same, excited; 17 to 24 special transmission; 25 to 28 confluent (C00, C10, C01, C11); 29 to 31
/// crossings with a signal along x, along y, and along both. The results equal Golly's.
///
/// jvn29: von Neumann, "Theory of Self-Reproducing Automata", 1966. nobili32: confluent cells with two
/// inputs and two outputs let signals cross (Nobili and Pesavento, 1996). hutton32: wires that are written
/// and retracted from their ends (Hutton, 2008).
enum class SignalRule { jvn29, nobili32, hutton32 };

/// Returns the number of states of a rule.
[[nodiscard]] int statesOf(SignalRule rule);

/// Returns the next state of a cell with the state `middle`. `around` holds the states to the east, north,
/// west and south.
[[nodiscard]] int signalOutcome(SignalRule rule, int middle, const std::array<int, 4>& around);

/// Returns the rule as a decision diagram, which is built on the first call (0.3 s).
[[nodiscard]] std::shared_ptr<const RuleTree> signalTree(SignalRule rule);

/// Returns a colour (linear RGB) for each state: shades of red for sensitized cells, blue for ordinary and
/// green for special transmission, yellow for confluent cells; bright if excited.
[[nodiscard]] std::vector<glm::vec3> signalColors(SignalRule rule);

}  // namespace simreel::sim
