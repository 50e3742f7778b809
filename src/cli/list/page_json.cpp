// simreel list --format json: writes the pages as JSON.
#include "cli/list/kind_notes.hpp"
#include "cli/list/pages.hpp"
#include "sim/world/list.hpp"

#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

using Json = nlohmann::ordered_json;

Json titlesJson(const std::vector<scene::HelpTitle>& titles) {
  Json list = Json::array();
  for (const scene::HelpTitle& title : titles)
    list.push_back({{"name", title.name}, {"sentence", title.doc}});
  return list;
}

/// Returns a default value as JSON. A default in words ("the preset's") becomes a string. If there is no
/// default, returns null.
Json standardJson(const scene::HelpRow& row) {
  if (row.standard == "off" || row.standard.empty()) return nullptr;
  Json value = Json::parse(row.standard, nullptr, false);
  return value.is_discarded() ? Json(row.standard) : value;
}

Json partsJson(std::string_view text) {
  Json list = Json::array();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('|'), text.size());
    list.push_back(std::string(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return list;
}

}  // namespace

std::string listJson() {
  const Json json = {{"kinds", titlesJson(scene::kindTitles(sim::kinds().list))},
                     {"sections", titlesJson(scene::sectionTitles())}};
  return json.dump(2) + "\n";
}

std::string pageJson(std::string_view name) {
  const std::string page(name.substr(0, name.find('.')));
  const scene::HelpPage help = scene::helpPage(page, sim::kinds().list);
  const bool part = page.size() < name.size();
  Json parameters = Json::array();
  for (const scene::HelpRow& row : part ? help.rowsAt(name.substr(page.size() + 1)) : help.rows) {
    const Json one = {{"name", row.name},
                      {"default", standardJson(row)},
                      {"range", row.range},
                      {"unit", row.unit},
                      {"sentence", row.doc}};
    parameters.push_back(one);
  }
  Json quantities = Json::array();
  for (const scene::Quantity& quantity : help.quantities)
    quantities.push_back({{"name", quantity.name}, {"unit", quantity.unit}, {"sentence", quantity.doc}});
  Json json = {{"name", help.name}, {"sentence", help.doc}, {"parameters", parameters}};
  if (help.isKind && !part) {
    json["quantities"] = quantities;
    json["states"] = partsJson(notesOf(page).states);
    json["sources"] = partsJson(notesOf(page).sources);
  }
  return json.dump(2) + "\n";
}

}  // namespace simreel::cli
