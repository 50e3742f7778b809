#include "golden/trace/state_difference.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace simreel::golden {

std::optional<std::uint64_t> ulpsBetween(std::uint32_t a, std::uint32_t b) {
  constexpr std::uint32_t sign = 0x80000000U;
  constexpr std::uint32_t infinity = 0x7f800000U;
  if ((a & ~sign) > infinity || (b & ~sign) > infinity) return std::nullopt;
  // Maps sign and magnitude to a position in the order of all floats. Both zeros have position 0.
  const auto place = [](std::uint32_t bits) {
    const auto magnitude = static_cast<std::int64_t>(bits & ~sign);
    return (bits & sign) != 0 ? -magnitude : magnitude;
  };
  const std::int64_t distance = place(a) - place(b);
  return static_cast<std::uint64_t>(distance < 0 ? -distance : distance);
}

ArrayDifference compareWords(const std::vector<std::uint32_t>& here,
                             const std::vector<std::uint32_t>& there) {
  SIMREEL_CHECK_EQ(here.size(), there.size());
  ArrayDifference result;
  result.elements = static_cast<std::int64_t>(here.size() / wordsPerElement);
  for (std::size_t at = 0; at + wordsPerElement <= here.size(); at += wordsPerElement) {
    if (std::equal(&here[at], &here[at] + wordsPerElement, &there[at])) continue;
    if (result.differing++ == 0) {
      result.first = static_cast<std::int64_t>(at / wordsPerElement);
      std::copy_n(&here[at], wordsPerElement, result.here.begin());
      std::copy_n(&there[at], wordsPerElement, result.there.begin());
    }
    bool nan = false;
    for (std::size_t k = at; k < at + wordsPerElement; ++k) {
      const auto ulps = ulpsBetween(here[k], there[k]);
      if (ulps)
        result.maxUlps = std::max(result.maxUlps, *ulps);
      else
        nan = nan || here[k] != there[k];
    }
    result.withNan += nan ? 1 : 0;
  }
  return result;
}

}  // namespace simreel::golden
