#pragma once
#include "golden/trace/lines.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace simreel::golden {

/// Representable numbers between two floats, given by their bits: 0 for +0 and -0, and 1 for neighbours.
/// Nothing where one is NaN.
[[nodiscard]] std::optional<std::uint64_t> ulpsBetween(std::uint32_t a, std::uint32_t b);

/// How far one state array is from another of the same size.
struct ArrayDifference {
  std::int64_t elements = 0;                                   ///< vec4 each
  std::int64_t differing = 0;                                  ///< elements with any bit different
  std::int64_t first = -1;                                     ///< the lowest of them
  std::array<std::uint32_t, wordsPerElement> here{}, there{};  ///< its bits
  std::uint64_t maxUlps = 0;                                   ///< over all components
  std::int64_t withNan = 0;  ///< differing elements that have NaN on a side; not in maxUlps
};
/// `words`: four for each element, as many on both sides.
[[nodiscard]] ArrayDifference compareWords(const std::vector<std::uint32_t>& here,
                                           const std::vector<std::uint32_t>& there);

}  // namespace simreel::golden
