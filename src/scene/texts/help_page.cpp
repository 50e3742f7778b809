#include "scene/texts/help_page.hpp"

#include "base/error.hpp"
#include "base/wrap.hpp"
#include "scene/json/words.hpp"
#include "scene/sections.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

constexpr std::size_t widestName = 26;

HelpPage scenePage() {
  Scene scene;
  HelpWriter table(false);
  table.add("version", "", std::to_string(sceneVersion), "",
            "Version of the scene format; every scene must give it.");
  describeScene(table, scene);
  table.add("objects", "{}", fmt::format("up to {}", maxObjects), "",
            "The objects that are simulated and drawn, each {kind, material} by name.");
  describeTests(table, scene, std::nullopt);
  HelpPage page{"scene", "A scene file as a whole.", false, table.rows(), {}, {}};
  page.appendix =
      "render, time, camera, sun, sky, ground, lights, material, test and checks have their own pages: "
      "simreel list NAME.\n"
      "Keyframes of a value that may move: {\"keys\": [[time, value], ...], \"ease\": \"linear\" or "
      "\"smooth\"}.\n";
  return page;
}

template <class Items, class Name>
std::size_t columnFor(const Items& items, Name name) {
  std::size_t widest = 4;
  for (const auto& item : items)
    if (const std::size_t columns = textColumns(name(item)); columns <= widestName)
      widest = std::max(widest, columns);
  return widest + 4;
}

/// Returns the table of quantities that checks and charts can use.
std::string quantitiesText(std::span<const Quantity> quantities, std::size_t width) {
  if (quantities.empty()) return "";
  const std::size_t column = columnFor(quantities, [](const Quantity& q) { return std::string(q.name); });
  std::string out = "\nMeasured, for \"what\" of \"checks\" and for charts:\n\n";
  for (const Quantity& q : quantities) {
    const std::string unit = *q.unit == '\0' ? "" : fmt::format(" [{}]", q.unit);
    out += listEntry(q.name, q.doc + unit, column, width);
  }
  return out;
}

/// Wraps lines that are too wide. Rows of a table wrap inside their second column.
std::string appendixText(const std::string& text, std::size_t width) {
  std::string out = "\n";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    const std::size_t gap = line.find("  ", indent);
    const std::size_t next = gap == std::string::npos ? indent : line.find_first_not_of(' ', gap);
    if (textColumns(line) <= width || next == std::string::npos || next + 20 > width)
      out += line + "\n";
    else
      out += line.substr(0, next) + wrapped(line.substr(next), width, next, next) + "\n";
    at = end + 1;
  }
  return out;
}

}  // namespace

std::string withoutBrackets(std::string_view path) {
  std::string plain;
  for (const char c : path)
    if (c != '[' && c != ']') plain += c;
  return plain;
}

std::vector<HelpRow> HelpPage::rowsAt(std::string_view path) const {
  const std::string wanted = withoutBrackets(path);
  std::vector<HelpRow> found;
  for (const HelpRow& row : rows) {
    const std::string plain = withoutBrackets(row.name);
    if (plain == wanted || plain.starts_with(wanted + ".")) found.push_back(row);
  }
  return found;
}

std::vector<HelpTitle> kindTitles(std::span<const Kind> kinds) {
  std::vector<HelpTitle> titles;
  for (const Kind& kind : kinds) titles.push_back({kind.name, kind.doc});
  return titles;
}

std::vector<HelpTitle> sectionTitles() {
  std::vector<HelpTitle> titles = {{"scene", "The scene file as a whole."}};
  for (const Section& section : sections()) titles.push_back({section.name, section.doc});
  return titles;
}

HelpPage helpPage(std::string_view name, std::span<const Kind> kinds) {
  if (name == "scene") return scenePage();
  for (const Section& section : sections())
    if (name == section.name) {
      HelpWriter table(true);
      section.describe(table);
      return {section.name, section.doc, false, table.rows(), {}, {}};
    }
  for (const Kind& kind : kinds)
    if (name == kind.name) {
      HelpWriter table(true);
      const auto parameters = kind.makeParameters();
      parameters->describe(table);
      const auto quantities = parameters->quantities();
      return {kind.name,
              kind.doc,
              true,
              table.rows(),
              {quantities.begin(), quantities.end()},
              kind.appendix ? kind.appendix() : ""};
    }
  std::vector<std::string> known;
  for (const HelpTitle& title : sectionTitles()) known.push_back(title.name);
  for (const HelpTitle& title : kindTitles(kinds)) known.push_back(title.name);
  fail(ExitCode::usage, "no kind of object and no section of a scene is named {}; {}",
       inQuotes(printable(name)), suggestion(name, known));
}

std::string rowsText(std::span<const HelpRow> rows, std::size_t width) {
  const std::size_t column = columnFor(rows, [](const HelpRow& row) { return row.name; });
  std::string out;
  for (const HelpRow& row : rows) {
    const std::string facts = row.facts();
    out += listEntry(row.name, facts.empty() ? row.doc : fmt::format("{} [{}]", row.doc, facts), column,
                     width);
  }
  return out;
}

std::string helpText(std::string_view name, std::span<const Kind> kinds, std::size_t width) {
  const HelpPage page = helpPage(name, kinds);
  std::string out = wrapped(fmt::format("{}: {}", page.name, page.doc), width) + "\n";
  if (page.isKind)
    out += fmt::format(
        "In a scene: \"objects\": {{\"name\": {{\"{}\": {{...}}, \"material\": {{...}}}}}}\n", page.name);
  out += "\n" + rowsText(page.rows, width) + quantitiesText(page.quantities, width);
  return page.appendix.empty() ? out : out + appendixText(page.appendix, width);
}

std::string listText(std::span<const Kind> kinds, std::size_t width) {
  const std::vector<HelpTitle> titles = kindTitles(kinds);
  const std::size_t column =
      std::max<std::size_t>(13, columnFor(titles, [](const HelpTitle& title) { return title.name; }));
  std::string out = "Kinds of objects:\n";
  for (const HelpTitle& title : titles) out += listEntry(title.name, title.doc, column, width);
  out += "\nSections of a scene:\n";
  for (const HelpTitle& title : sectionTitles()) out += listEntry(title.name, title.doc, column, width);
  return out;
}

}  // namespace simreel::scene
