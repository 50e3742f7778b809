#include "golden/report/html.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/report/json.hpp"

#include <string_view>

namespace simreel::golden {

namespace {

constexpr std::string_view dataName = "report.json";

std::string_view pageFile(std::string_view path) {
  for (const PageFile& file : pageFiles())
    if (path == file.path) return file.text;
  brokenInvariant(__FILE__, __LINE__, "the report's page includes a file that is built in",
                  std::string(path));
}

/// JSON that cannot end its script element or begin a comment in it, whatever its strings hold: outside of
/// strings JSON has no "<".
std::string withoutMarkup(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

}  // namespace

std::string htmlReport(const std::string& reportJson) {
  // index.html names what is pasted into it as {{file}}. What was pasted is not searched again, so data may
  // hold such marks.
  std::string page;
  std::string_view rest = pageFile("index.html");
  while (true) {
    const auto open = rest.find("{{");
    const auto close = rest.find("}}", open);
    page += rest.substr(0, open);
    if (close == std::string_view::npos) return page;
    const std::string_view name = rest.substr(open + 2, close - open - 2);
    if (name == dataName)
      page += withoutMarkup(reportJson);
    else
      page += pageFile(name);
    rest.remove_prefix(close + 2);
  }
}

void writeReportPage(const std::filesystem::path& folder, const std::string& reportJson) {
  writeFileAtomically(folder / "index.html", std::string_view(htmlReport(reportJson)));
}

void writeHtmlReport(const std::filesystem::path& folder, const SuiteResult& suite) {
  writeReportPage(folder, reportText(suite));
}

}  // namespace simreel::golden
