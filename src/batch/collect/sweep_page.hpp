#pragma once
#include "batch/collect/sweep_tables.hpp"

#include <optional>
#include <span>
#include <string>

namespace simreel::batch {

/// Source file of the page that is built into the program: path below src/batch/collect/page/ and text.
struct PageFile {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const PageFile> pageFiles();

/// Returns an HTML page for browsing the jobs by their parameters. The page contains style, script, data
/// and small copies of the pictures. If it is stored in the sweep's folder, it shows the full pictures.
[[nodiscard]] std::string sweepPage(const CollectedSweep& sweep, std::optional<int> frame);

}  // namespace simreel::batch
