#include "golden/report/html.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "golden/report/json.hpp"

#include <map>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <nlohmann/json.hpp>

namespace simreel::golden {

namespace {

using nlohmann::ordered_json;

constexpr std::string_view dataName = "report.json";

std::string_view pageFile(std::string_view path) {
  for (const PageFile& file : pageFiles())
    if (path == file.path) return file.text;
  brokenInvariant(__FILE__, __LINE__, "the report's page includes a file that is built in",
                  std::string(path));
}

/// Escapes '<' in JSON, so that no string can end the page's script element or start a comment in it. JSON
/// contains '<' only in strings.
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

/// Removes repetition from the data. The function unpacked() of the page restores it. The output is
/// {"keys": [[...], ...], "texts": [...], "data": ...}. An object becomes [index of its key list,
/// values...], a list becomes [-1, values...], and a text that occurs several times becomes {"t": index}.
/// Packing reduces a report of 500 failures to a quarter of its size.
class Packer {
 public:
  std::string packed(const ordered_json& value) {
    count(value);
    ordered_json data = pack(value);
    return ordered_json{{"keys", std::move(keys_)}, {"texts", std::move(texts_)}, {"data", std::move(data)}}
        .dump();
  }

 private:
  // max length of texts that are never replaced, because {"t": index} is not shorter
  static constexpr std::size_t shortText = 10;

  struct Text {
    int times = 0, number = -1;
  };

  void count(const ordered_json& value) {
    if (value.is_string()) ++known_[value.get_ref<const std::string&>()].times;
    if (value.is_structured())
      for (const ordered_json& member : value) count(member);
  }

  ordered_json pack(const ordered_json& value) {
    if (value.is_string()) return packText(value.get_ref<const std::string&>());
    if (!value.is_structured()) return value;
    ordered_json packed = ordered_json::array({value.is_object() ? numberOfKeys(value) : -1});
    for (const ordered_json& member : value) packed.push_back(pack(member));
    return packed;
  }

  ordered_json packText(const std::string& text) {
    Text& known = known_[text];
    if (known.times < 2 || text.size() <= shortText) return text;
    if (known.number < 0) {
      known.number = static_cast<int>(texts_.size());
      texts_.push_back(text);
    }
    return {{"t", known.number}};
  }

  int numberOfKeys(const ordered_json& object) {
    ordered_json keys = ordered_json::array();
    for (const auto& member : object.items()) keys.push_back(member.key());
    const auto [found, isNew] = numbers_.try_emplace(keys.dump(), static_cast<int>(numbers_.size()));
    if (isNew) keys_.push_back(std::move(keys));
    return found->second;
  }

  std::map<std::string, int> numbers_;
  std::unordered_map<std::string, Text> known_;
  ordered_json keys_ = ordered_json::array(), texts_ = ordered_json::array();
};

}  // namespace

std::string htmlReport(const std::string& reportJson) {
  // Replaces each {{file}} in index.html by the content of that file. Inserted content is not searched
  // again, so data may contain {{...}}.
  std::string page;
  std::string_view rest = pageFile("index.html");
  while (true) {
    const auto open = rest.find("{{");
    const auto close = rest.find("}}", open);
    page += rest.substr(0, open);
    if (close == std::string_view::npos) return page;
    const std::string_view name = rest.substr(open + 2, close - open - 2);
    if (name == dataName)
      page += withoutMarkup(Packer().packed(ordered_json::parse(reportJson)));
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
