#pragma once
#include <string>
#include <string_view>

namespace simreel::sim {

/// An outer-totalistic rule on the Moore neighbourhood: bit n of a mask for n living neighbours.
struct LifeRule {
  int born = 1 << 3;
  int survives = 1 << 2 | 1 << 3;
  bool operator==(const LifeRule&) const = default;
  /// As "B3/S23".
  [[nodiscard]] std::string text() const;
};

/// What parseLifeRule found wrong: at which character of the text, from 0.
struct LifeRuleProblem {
  std::size_t at = 0;
  std::string message;  ///< empty: nothing
};

/// Reads "B3/S23" and "S23/B3" (letters of either case, the slash may be missing), or the older "23/3"
/// (survival first). Digits are 0 to 8, each at most once. Nothing else: what other programs know besides
/// (Generations, Hensel's letters, other neighbourhoods) is named in the message.
[[nodiscard]] LifeRuleProblem parseLifeRule(std::string_view text, LifeRule& rule);

}  // namespace simreel::sim
