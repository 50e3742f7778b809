#pragma once
#include "batch/collect/sweep_tables.hpp"

#include <optional>
#include <span>
#include <string>

namespace simreel::batch {

/// A source file of the page built into the program: path below src/batch/collect/page/ and text.
struct PageFile {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const PageFile> pageFiles();

/// A page to look through the jobs by their parameters: style, script, data and small copies of the
/// pictures inside. It shows the whole pictures where it lies in the sweep's folder.
[[nodiscard]] std::string sweepPage(const CollectedSweep& sweep, std::optional<int> frame);

}  // namespace simreel::batch
