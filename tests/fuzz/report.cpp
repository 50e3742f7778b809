// Fuzzes the reader of report.json, and all outputs that are made from a report.
#include "base/error.hpp"
#include "fuzz/reader.hpp"
#include "golden/report/github.hpp"
#include "golden/report/json.hpp"
#include "golden/report/junit.hpp"
#include "golden/report/markdown.hpp"
#include "golden/report/text.hpp"
#include "golden/result.hpp"

namespace simreel::fuzz {
namespace {

void readReport(std::string_view bytes) {
  const golden::SuiteResult suite = golden::parseReport(std::string(bytes), "report.json");
  const std::string text = golden::reportText(suite);
  SIMREEL_CHECK_EQ(golden::reportText(golden::parseReport(text, "again.json")), text);
  static_cast<void>(golden::junitText(suite));
  static_cast<void>(golden::githubAnnotations(suite));
  static_cast<void>(golden::markdownSummary(suite));
  static_cast<void>(golden::closingText(suite));
  for (const auto& scene : suite.scenes) static_cast<void>(golden::sceneLine(scene));
}

const Reader reportReader("report", readReport);

}  // namespace
}  // namespace simreel::fuzz
