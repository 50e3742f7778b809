#include "base/error.hpp"
#include "golden/report/html.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace simreel;
namespace fs = std::filesystem;

namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++n;
  return n;
}

/// Returns the text of the script element with the data.
std::string dataOf(const std::string& page) {
  const std::string open = "<script id=\"data\" type=\"application/json\">";
  const auto begin = page.find(open) + open.size();
  return page.substr(begin, page.find("</script>", begin) - begin);
}

/// Unpacks the data as model.js does. An object is a list of the index of its key list and its values. A
/// list begins with -1.
nlohmann::json unpacked(const nlohmann::json& all, const nlohmann::json& packed) {
  if (packed.is_object()) return all["texts"].at(packed.at("t").get<std::size_t>());
  if (!packed.is_array()) return packed;
  const int number = packed.at(0).get<int>();
  nlohmann::json made = number < 0 ? nlohmann::json::array() : nlohmann::json::object();
  for (std::size_t i = 1; i < packed.size(); ++i) {
    if (number < 0)
      made.push_back(unpacked(all, packed[i]));
    else
      made[all["keys"].at(std::size_t(number)).at(i - 1).get<std::string>()] = unpacked(all, packed[i]);
  }
  return made;
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / "simreel-report-html-test") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(Folder&&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

TEST_CASE("html report: embedded data is read back exactly, for any text") {
  const nlohmann::json data = {
      {"list", {1, nullptr, nlohmann::json::array(), {{"a", {{"b", 2.5}}}}, {{"a", "c"}}}},
      {"none", nlohmann::json::object()},
      {"twice", {"the same words", "the same words", "short", "short"}},
      {"name", "</script><!-- <script> ]]> & \" ' \xe2\x80\xa8 {{app.js}}"}};
  const std::string page = golden::htmlReport(data.dump(1));
  const auto packed = nlohmann::json::parse(dataOf(page));
  CHECK(unpacked(packed, packed["data"]) == data);
  CHECK(dataOf(page).find('<') == std::string::npos);
  CHECK(dataOf(page).find("{{app.js}}") != std::string::npos);
}

TEST_CASE("html report: all files are embedded once and nothing external is referenced") {
  const std::string page = golden::htmlReport("{}");
  CHECK(golden::pageFiles().size() >= 8);
  for (const golden::PageFile& file : golden::pageFiles()) {
    if (std::string(file.path) == "index.html") continue;
    CAPTURE(file.path);
    CHECK(count(page, file.text) == 1);
    // Page files must not contain text that ends their script or style element early.
    CHECK(std::string(file.text).find("</") == std::string::npos);
  }
  CHECK(count(page, "{{") == 0);
  // The only URL in the page is the name of the SVG namespace.
  CHECK(count(page, "://") == 1);
  CHECK(count(page, "http://www.w3.org/2000/svg") == 1);
  CHECK(count(page, "innerHTML") == 0);
  CHECK(golden::htmlReport("{}") == page);
}

TEST_CASE("html report: the report is written completely, or a one-line error says why not") {
  const Folder folder;
  golden::writeReportPage(folder.path(), "{\"a\": 1}");
  std::ifstream file(folder.path() / "index.html", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  CHECK(text == golden::htmlReport("{\"a\": 1}"));

  const fs::path gone = folder.path() / "gone";
  try {
    golden::writeReportPage(gone, "{}");
    FAIL("an error was expected");
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::inputOutput);
    const std::string message = error.what();
    CHECK(message.find((gone / "index.html").string()) != std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
}
