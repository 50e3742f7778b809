#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace simreel::golden {

/// A source file of the report's page built into the program: path below src/golden/report/page/ and text.
struct PageFile {
  const char* path;
  const char* text;
};
[[nodiscard]] std::span<const PageFile> pageFiles();

/// The report as one HTML page with style, script and the data (`reportJson`, what reportText makes)
/// inside. It refers to nothing but the images that the data names, relative to the page.
[[nodiscard]] std::string htmlReport(const std::string& reportJson);

/// Writes htmlReport(reportJson) as index.html into the folder, whole or not at all. Throws
/// UserError(inputOutput) naming the file and the system's reason.
void writeReportPage(const std::filesystem::path& folder, const std::string& reportJson);

/// Writes index.html into `folder`, which holds report.json and the images already.
void writeHtmlReport(const std::filesystem::path& folder, const SuiteResult& suite);

}  // namespace simreel::golden
