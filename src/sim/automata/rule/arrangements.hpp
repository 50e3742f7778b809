#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Arrangements of living neighbours that turning and mirroring leave alike, in Hensel's letters: for 1 to
/// 7 neighbours a letter tells which.
inline constexpr std::string_view arrangementLetters = "cekainyqjrtwz";

/// Letters that there are for `count` neighbours, bit i for arrangementLetters[i]; 1 for 0 and 8, which
/// have one arrangement and no letter.
[[nodiscard]] int lettersOf(int count);

/// How many neighbours live in a neighbourhood (bits of nine cells as CellRule::map has them; the middle is
/// no neighbour), and which letter that is (0 for 0 and 8 neighbours).
struct Arrangement {
  int count = 0;
  int letter = 0;
};
[[nodiscard]] Arrangement arrangementOf(unsigned neighbourhood);

/// The shortest way to write `letters` (bits) of `count`: "2", "2ce", "2-a"; empty for none.
[[nodiscard]] std::string arrangementText(int count, int letters);

}  // namespace simreel::sim
