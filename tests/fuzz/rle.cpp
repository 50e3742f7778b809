// Fuzzes the readers of patterns. A valid pattern in any format, written as RLE and read again, must be the
// same.
#include "sim/life/rle.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"

namespace simreel::fuzz {
namespace {

/// Maximum size of grids whose written files are read again.
constexpr long maxWords = 1 << 16;

void readRle(std::string_view bytes) {
  if (bytes.starts_with("[M2]"))
    return;  // macrocell.cpp tests these patterns, because they need a limit on the number of cells.
  const sim::CellPattern pattern = sim::parsePattern(bytes, "fuzz.rle");
  const long rowWords = sim::CellRows::rowWords(pattern.size.x);
  for (const auto& run : pattern.runs)
    SIMREEL_CHECK(run.x >= 0 && run.y >= 0 && run.length > 0 && run.x + run.length <= pattern.size.x &&
                  run.y < pattern.size.y);
  if (rowWords * pattern.size.y > maxWords || pattern.highest > 1) return;
  std::vector<std::uint32_t> words(static_cast<std::size_t>(rowWords * pattern.size.y));
  for (const auto& run : pattern.runs)
    for (int x = run.x; x < run.x + run.length; ++x)
      words[static_cast<std::size_t>(run.y * rowWords + x / 32)] |= 1U << (x % 32);
  const sim::CellRule rule = pattern.rule.value_or(sim::CellRule());
  const std::string text = sim::writeRle({pattern.size, words}, rule, "", "fuzz");
  const sim::CellPattern again = sim::parseRle(text, "again.rle");
  SIMREEL_CHECK(again.size == pattern.size && again.rule == rule);
  std::vector<std::uint32_t> back(words.size());
  for (const auto& run : again.runs)
    for (int x = run.x; x < run.x + run.length; ++x)
      back[static_cast<std::size_t>(run.y * rowWords + x / 32)] |= 1U << (x % 32);
  SIMREEL_CHECK(back == words);
}

const Reader rleReader("rle", readRle);

}  // namespace
}  // namespace simreel::fuzz
