// simreel list --format markdown: writes the pages as Markdown.
#include "cli/list/kind_notes.hpp"
#include "cli/list/pages.hpp"
#include "sim/world/list.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::cli {

namespace {

using scene::HelpPage;
using scene::HelpRow;

/// Escapes text for a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '<' || c == '>') out += '\\';
    out += c;
  }
  return out;
}

std::string code(const std::string& text) {
  if (text.empty()) return "";
  std::string safe;
  for (const char c : text) safe += c == '|' ? std::string("\\|") : std::string(1, c);
  return "`" + safe + "`";
}

/// Formats a default value for a table cell: JSON values as code, words as plain text.
std::string standardCell(const std::string& text) {
  const bool isCode =
      !text.empty() && (text[0] == '"' || text[0] == '[' || text[0] == '{' || text[0] == '-' ||
                        (text[0] >= '0' && text[0] <= '9') || text == "true" || text == "false");
  return isCode && text.find("\" ") == std::string::npos && text.find("\",") == std::string::npos
             ? code(text)
             : cell(text);
}

std::string rowsTable(const std::vector<HelpRow>& rows) {
  std::string out = "| name | default | range | unit | meaning |\n|---|---|---|---|---|\n";
  for (const HelpRow& row : rows)
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.name, standardCell(row.standard),
                       cell(row.range), cell(row.unit), cell(row.doc));
  return out;
}

/// Returns one table for the parameters without a prefix and one table for each prefix.
std::string parameterTables(const HelpPage& page) {
  std::vector<HelpRow> plain;
  for (const HelpRow& row : page.rows)
    if (row.name.find('.') == std::string::npos) plain.push_back(row);
  std::string out = "\n## Parameters\n\n" + rowsTable(plain);
  for (const HelpRow& group : plain) {
    std::vector<HelpRow> rows;
    for (const HelpRow& row : page.rows) {
      const std::string prefix = row.name.substr(0, row.name.find('.'));
      if (row.name.size() > prefix.size() && scene::withoutBrackets(prefix) == group.name)
        rows.push_back(row);
    }
    if (!rows.empty()) out += fmt::format("\n### {}\n\n{}\n\n{}", group.name, group.doc, rowsTable(rows));
  }
  return out;
}

std::string quantitiesTable(const HelpPage& page) {
  if (page.quantities.empty()) return "";
  std::string out =
      "\n## Measured quantities\n\nChecks (`\"what\"`), charts (`OBJECT.QUANTITY`) and texts "
      "(`{OBJECT.QUANTITY}`) can use them.\n\n| name | unit | meaning |\n|---|---|---|\n";
  for (const scene::Quantity& q : page.quantities)
    out += fmt::format("| `{}` | {} | {} |\n", q.name, cell(q.unit), cell(q.doc));
  return out;
}

std::vector<std::string_view> parts(std::string_view text) {
  std::vector<std::string_view> all;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('|'), text.size());
    all.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return all;
}

std::string notesText(const KindNotes& notes) {
  std::string out;
  if (!notes.states.empty())
    out +=
        "\n## State arrays\n\n`simreel trace` prints a hash of each, and a check's `\"of\"` names them.\n\n"
        "| array | meaning |\n|---|---|\n";
  for (const std::string_view state : parts(notes.states)) {
    const std::size_t colon = state.find(": ");
    out += fmt::format("| `{}` | {} |\n", state.substr(0, colon), cell(state.substr(colon + 2)));
  }
  if (!notes.sources.empty()) out += "\n## Sources\n\n";
  for (const std::string_view source : parts(notes.sources)) out += fmt::format("- {}\n", source);
  return out;
}

}  // namespace

std::string listMarkdown() {
  const auto table = [](const std::vector<scene::HelpTitle>& titles) {
    std::string rows = "| page | what it describes |\n|---|---|\n";
    for (const scene::HelpTitle& title : titles)
      rows += fmt::format("| [{0}]({0}.md) | {1} |\n", title.name, cell(title.doc));
    return rows;
  };
  return "# Reference\n\nThe program writes these pages: `simreel list --reference FOLDER`.\n\n"
         "## Kinds of objects\n\n" +
         table(scene::kindTitles(sim::kinds().list)) + "\n## Sections of a scene\n\n" +
         table(scene::sectionTitles()) +
         "\n## The program\n\n"
         "| page | what it describes |\n|---|---|\n"
         "| [Command line](command-line.md) | All commands and their options. |\n"
         "| [Exit codes](exit-codes.md) | The codes that commands end with. |\n"
         "| [Environment variables](environment.md) | The variables that the program reads. |\n"
         "| [Messages](errors.md) | The most frequent messages, each with its cure. |\n";
}

std::string pageMarkdown(std::string_view name) {
  const HelpPage page = scene::helpPage(name, sim::kinds().list);
  std::string out = fmt::format("# {}\n\n{}\n", page.name, page.doc);
  if (page.isKind)
    out += fmt::format(
        "\n![A scene of the kind {0}](../pictures/starter_{0}.png)\n\n## Smallest scene\n\n"
        "`simreel new {0}` prints it. The picture shows its last frame.\n\n```json\n{1}```\n",
        page.name, starterText(page.name));
  out += parameterTables(page) + quantitiesTable(page);
  if (!page.appendix.empty()) out += "\n## Presets and notation\n\n```text\n" + page.appendix + "```\n";
  return out + (page.isKind ? notesText(notesOf(page.name)) : "");
}

}  // namespace simreel::cli
