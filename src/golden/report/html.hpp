#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace simreel::golden {

/// A source file of the report page that is built into the program: its path below src/golden/report/page/,
/// and its text.
struct PageFile {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const PageFile> pageFiles();

/// Returns the report as a single HTML page that contains styles, scripts and the data. `reportJson`:
/// result of reportText(). The page refers only to the image files named in the data, by paths relative to
/// the page.
[[nodiscard]] std::string htmlReport(const std::string& reportJson);

/// Writes htmlReport(reportJson) atomically as index.html into the folder. Throws UserError(inputOutput),
/// whose message contains the file's name and the system's reason.
void writeReportPage(const std::filesystem::path& folder, const std::string& reportJson);

/// Writes index.html into `folder`, which already contains report.json and the images.
void writeHtmlReport(const std::filesystem::path& folder, const SuiteResult& suite);

}  // namespace simreel::golden
