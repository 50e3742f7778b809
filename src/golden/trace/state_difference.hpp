#pragma once
#include "golden/trace/lines.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace simreel::golden {

/// Returns the number of steps between adjacent representable floats from one float to another. Both are
/// given by their bits. The result is 0 for +0 and -0, and 1 for neighbours. Returns nothing if one of the
/// floats is NaN.
[[nodiscard]] std::optional<std::uint64_t> ulpsBetween(std::uint32_t a, std::uint32_t b);

/// Differences between two state arrays of equal size.
struct ArrayDifference {
  std::int64_t elements = 0;  ///< number of vec4 elements in the array
  /// number of elements that differ in any bit
  std::int64_t differing = 0;
  /// index of the first differing element; -1 if all are equal
  std::int64_t first = -1;
  std::array<std::uint32_t, wordsPerElement> here{}, there{};  ///< bits of the first differing element
  /// largest difference of any component in ULPs
  std::uint64_t maxUlps = 0;
  /// number of differing elements with NaN on one side; they are not included in maxUlps
  std::int64_t withNan = 0;
};
/// Compares the words of two arrays, four words per element. Both arrays must have equal sizes.
[[nodiscard]] ArrayDifference compareWords(const std::vector<std::uint32_t>& here,
                                           const std::vector<std::uint32_t>& there);

}  // namespace simreel::golden
