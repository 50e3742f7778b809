#include "golden/report_html.hpp"
#include "golden/result.hpp"

namespace simreel::golden {

void writeHtmlReport(const std::filesystem::path& folder, const SuiteResult& suite) {
  writeReportPage(folder, reportText(suite));
}

}  // namespace simreel::golden
