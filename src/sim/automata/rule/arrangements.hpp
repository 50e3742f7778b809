#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Letters of Hensel's notation. A letter names a class of arrangements of 1 to 7 live neighbours that are
/// equal up to rotation and reflection.
inline constexpr std::string_view arrangementLetters = "cekainyqjrtwz";

/// Returns the set of letters that exist for `count` neighbours, where bit i stands for
/// arrangementLetters[i]. For 0 and 8 neighbours it is 1, although their only arrangement has no letter.
[[nodiscard]] int lettersOf(int count);

/// Number of live neighbours in a neighbourhood (nine bits as in CellRule::map, without the centre), and
/// the index of the arrangement's letter (0 for 0 and 8 neighbours).
struct Arrangement {
  int count = 0;
  int letter = 0;
};
[[nodiscard]] Arrangement arrangementOf(unsigned neighbourhood);

/// Returns the shortest notation of a set of `letters` (bits) for `count` neighbours, such as "2", "2ce" or
/// "2-a"; empty for an empty set.
[[nodiscard]] std::string arrangementText(int count, int letters);

}  // namespace simreel::sim
