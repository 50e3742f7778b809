// Fuzzes the reader of macrocell patterns. A valid pattern, written as RLE and read again, must have the
// same cells.
#include "sim/life/macrocell.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "sim/life/rle.hpp"

#include <algorithm>
#include <vector>

namespace simreel::fuzz {
namespace {

/// Maximum number of cells that are compared, because a few lines can describe more cells than fit into
/// memory.
constexpr std::size_t maxCells = std::size_t{1} << 16;
/// Maximum size of grids that are written.
constexpr long maxBytes = 1 << 18;

/// Returns the runs sorted by row and then from left to right. Adjacent runs are joined.
std::vector<sim::CellPattern::Run> sortedRuns(std::vector<sim::CellPattern::Run> runs) {
  std::sort(runs.begin(), runs.end(),
            [](const auto& a, const auto& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  std::vector<sim::CellPattern::Run> joined;
  for (const sim::CellPattern::Run& run : runs) {
    const bool follows = !joined.empty() && joined.back().y == run.y &&
                         joined.back().x + joined.back().length == run.x &&
                         joined.back().state == run.state;
    if (follows)
      joined.back().length += run.length;
    else
      joined.push_back(run);
  }
  return joined;
}

void readMacrocell(std::string_view bytes) {
  const sim::CellPattern pattern = sim::parseMacrocell(bytes, "fuzz.mc", maxCells);
  const auto runs = sortedRuns(pattern.runs);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& run = runs[i];
    SIMREEL_CHECK(run.x >= 0 && run.y >= 0 && run.length > 0 && run.x + run.length <= pattern.size.x &&
                  run.y < pattern.size.y && run.state > 0 && run.state <= pattern.highest);
    // Checks that runs do not overlap.
    if (i > 0 && runs[i - 1].y == run.y) SIMREEL_CHECK(runs[i - 1].x + runs[i - 1].length <= run.x);
  }
  const long rowBytes = sim::StateRows::rowBytes(pattern.size.x);
  if (rowBytes * pattern.size.y > maxBytes || runs.empty()) return;
  std::vector<std::uint8_t> cells(static_cast<std::size_t>(rowBytes * pattern.size.y));
  for (const auto& run : runs)
    std::fill_n(cells.begin() + run.y * rowBytes + run.x, run.length, static_cast<std::uint8_t>(run.state));
  const sim::CellPattern again =
      sim::parseRle(sim::writeStatesRle({pattern.size, cells}, sim::CellRule(), "", ""), "again.rle");
  const auto back = sortedRuns(again.runs);
  SIMREEL_CHECK(back.size() == runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i)
    SIMREEL_CHECK(back[i].x == runs[i].x && back[i].y == runs[i].y && back[i].length == runs[i].length &&
                  back[i].state == runs[i].state);
}

const Reader macrocellReader("macrocell", readMacrocell);

}  // namespace
}  // namespace simreel::fuzz
