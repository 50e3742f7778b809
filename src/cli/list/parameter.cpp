// simreel list cloth.pins, and simreel list --search WORDS: describes one parameter, or searches all.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/wrap.hpp"
#include "cli/list/pages.hpp"
#include "scene/json/diagnostics.hpp"
#include "scene/json/json_node.hpp"
#include "scene/json/words.hpp"
#include "scene/shipped_scene.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

namespace simreel::cli {

namespace {

using scene::HelpPage;
using scene::HelpRow;
using scene::Node;

std::vector<std::string> split(std::string_view text, char between) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == between)
      parts.emplace_back();
    else
      parts.back() += c;
  std::erase(parts, "");
  return parts;
}

/// Collects the values at `path` below `node`. At a list, continues with every item.
void collectValues(const Node& node, const std::vector<std::string>& path, std::size_t at,
                   std::vector<const Node*>& found) {
  if (at == path.size()) return found.push_back(&node);
  const bool named = path[at].ends_with(">") || path[at] == "light";  // true for a key that the author of
                                                                      // the scene chooses
  for (const Node& child : node.children)
    if (node.kind == Node::Kind::list)
      collectValues(child, path, at, found);
    else if (named || child.key == path[at])
      collectValues(child, path, at + 1, found);
}

/// Returns JSON text on one line, with single spaces between tokens.
std::string onOneLine(std::string_view text) {
  std::string out;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
    const bool space = !quoted && std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!space)
      out += c;
    else if (!out.empty() && out.back() != ' ' && out.back() != '[' && out.back() != '{')
      out += ' ';
  }
  return out;
}

/// Returns a value within the parameter's range, for parameters that no shipped scene sets.
std::string madeUpValue(const HelpRow& row) {
  if (row.group) return row.range.starts_with("up to") && row.standard != "{}" ? "[{...}]" : "{...}";
  const auto standard = nlohmann::json::parse(row.standard, nullptr, false);
  if (row.range == "true, false") return row.standard == "true" ? "false" : "true";
  if (row.range == "file") return "\"FILE\"";
  if (row.range == "text") return "\"TEXT\"";
  if (!standard.is_discarded() && !standard.is_null() && !(standard.is_array() && standard.empty()))
    return row.standard;
  if (std::isdigit(static_cast<unsigned char>(row.range[0])) != 0 || row.range[0] == '-')
    return row.range.substr(0, row.range.find(".."));
  if (row.range[0] == '>' || row.range == "any") return "1";
  return "\"" + row.range.substr(0, row.range.find(',')) + "\"";
}

/// Returns an example of a parameter as a JSON member: "name": value.
std::string exampleText(const HelpPage& page, const HelpRow& row) {
  const std::string member = row.name.substr(row.name.rfind('.') + 1);
  if (const auto shipped = shippedValue(page, row.name))
    return fmt::format("\"{}\": {} (scenes/{}.json)", member, shipped->text, shipped->scene);
  if (!row.group) return fmt::format("\"{}\": {}", member, madeUpValue(row));
  for (const HelpRow& inner : page.rows)
    if (inner.name.starts_with(row.name + ".") && !inner.group)
      return fmt::format("\"{}\": {{\"{}\": {}}}", member, inner.name.substr(row.name.size() + 1),
                         madeUpValue(inner));
  return fmt::format("\"{}\": {}", member, madeUpValue(row));
}

/// Returns the path of a parameter for -D: "objects.NAME.cloth.pins.0.every".
std::string overridePath(const HelpPage& page, const HelpRow& row) {
  std::string path = page.isKind               ? "objects.NAME." + page.name + "."
                     : page.name == "scene"    ? ""
                     : page.name == "material" ? "objects.NAME.material."
                     : page.name == "lights"   ? "lights.NAME."
                     : page.name == "checks"   ? "checks.0."
                                               : page.name + ".";
  std::string rest = row.name;
  for (std::size_t at; (at = rest.find("[]")) != std::string::npos;) rest.replace(at, 2, ".0");
  return path + rest;
}

void addFact(std::string& out, const char* name, const std::string& text, std::size_t width) {
  if (!text.empty()) out += listEntry(name, text, 12, width);
}

bool holds(const std::string& text, const std::vector<std::string>& words) {
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return lower.find(word) != std::string::npos; });
}

}  // namespace

std::optional<ShippedValue> shippedValue(const HelpPage& page, std::string_view parameter) {
  static const std::vector<std::pair<std::string, std::string>> texts = [] {
    std::vector<std::pair<std::string, std::string>> all;
    for (const std::string& name : scene::shippedScenes())
      all.emplace_back(name, readFile(assetFolder() / "scenes" / (name + ".json"), "scene"));
    return all;
  }();
  static const std::vector<std::optional<Node>> roots = [] {
    std::vector<std::optional<Node>> all;
    for (const auto& [name, text] : texts) {
      scene::Diagnostics diagnostics(name, text);
      all.push_back(scene::parseJson(text, 0, 0, diagnostics));
    }
    return all;
  }();
  std::vector<std::string> path = page.isKind || page.name == "material"
                                      ? std::vector<std::string>{"objects", "<name>", page.name}
                                  : page.name == "scene" ? std::vector<std::string>{}
                                                         : std::vector<std::string>{page.name};
  if (page.name == "lights") path.emplace_back("<name>");
  for (const std::string& step : split(scene::withoutBrackets(parameter), '.')) path.push_back(step);
  constexpr std::size_t longest = 160;
  std::optional<ShippedValue> best;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (!roots[i]) continue;
    std::vector<const Node*> found;
    collectValues(*roots[i], path, 0, found);
    for (const Node* node : found) {
      const std::string text =
          onOneLine(std::string_view(texts[i].second).substr(node->begin, node->end - node->begin));
      if (text.size() > longest || text.find("//") != std::string::npos) continue;
      if (text == "[]" || text == "{}" || text == "true" || text == "false" || text == "[{}]") continue;
      if (!best || text.size() < best->text.size()) best = ShippedValue{text, texts[i].first};
    }
  }
  return best;
}

std::string parameterText(std::string_view path, std::size_t width) {
  const std::size_t dot = path.find('.');
  const HelpPage page = scene::helpPage(path.substr(0, dot), sim::kinds().list);
  const std::string wanted(path.substr(dot + 1));
  std::vector<HelpRow> rows = page.rowsAt(wanted);
  if (rows.empty()) {
    std::vector<std::string> names;
    for (const HelpRow& row : page.rows) names.push_back(scene::withoutBrackets(row.name));
    const std::string words = scene::suggestion(scene::withoutBrackets(wanted), names);
    fail(ExitCode::usage, "{} has no parameter {}; {}", page.name,
         scene::inQuotes(scene::printable(wanted)),
         words.starts_with("did you mean") ? words : "`simreel list " + page.name + "` names them all");
  }
  const HelpRow row = rows.front();
  std::string out = wrapped(fmt::format("{}.{}: {}", page.name, row.name, row.doc), width) + "\n\n";
  addFact(out, "default", row.standard, width);
  addFact(out, "range", row.range, width);
  addFact(out, "unit", row.unit, width);
  addFact(out, "example", exampleText(page, row), width);
  addFact(out, "override", fmt::format("-D {}=VALUE", overridePath(page, row)), width);
  rows.erase(rows.begin());
  return rows.empty() ? out : out + "\nIn it:\n\n" + scene::rowsText(rows, width);
}

std::string searchText(const std::string& words, std::size_t width) {
  std::string lower = words;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  const std::vector<std::string> wanted = split(lower, ' ');
  if (wanted.empty()) fail(ExitCode::usage, "--search needs a word, for example --search viscosity");
  std::vector<scene::HelpTitle> found;
  std::vector<scene::HelpTitle> titles = scene::kindTitles(sim::kinds().list);
  for (scene::HelpTitle& section : scene::sectionTitles()) titles.push_back(std::move(section));
  for (const scene::HelpTitle& title : titles) {
    if (holds(title.name + " " + title.doc, wanted)) found.push_back(title);
    if (title.name == "scene") continue;  // The pages of the sections already contain these rows.
    const HelpPage page = scene::helpPage(title.name, sim::kinds().list);
    for (const HelpRow& row : page.rows) {
      const std::string name = page.name + "." + row.name;
      if (holds(fmt::format("{} {} {}", name, row.range, row.doc), wanted))
        found.push_back({name, fmt::format("{} [{}]", row.doc, row.facts())});
    }
    for (const scene::Quantity& quantity : page.quantities)
      if (holds(fmt::format("{} {}", quantity.name, quantity.doc), wanted))
        found.push_back({fmt::format("{} measures {}", page.name, quantity.name), quantity.doc});
  }
  if (found.empty())
    fail(ExitCode::usage, "nothing in `simreel list` holds \"{}\"; try one shorter word", words);
  std::string out;
  for (const scene::HelpTitle& one : found) out += listEntry(one.name, one.doc, 32, width);
  return out;
}

}  // namespace simreel::cli
