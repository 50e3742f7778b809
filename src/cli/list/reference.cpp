// simreel list --reference FOLDER: writes the reference as Markdown files.
#include "cli/list/reference.hpp"

#include "base/file.hpp"
#include "base/log.hpp"
#include "cli/help/exit_codes.hpp"
#include "cli/help/option_text.hpp"
#include "cli/list/environment.hpp"
#include "cli/list/messages.hpp"
#include "cli/list/pages.hpp"
#include "sim/world/list.hpp"

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

std::string markdownCell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '<' || c == '>') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string optionsTable(const CLI::App& command, bool arguments) {
  std::string out;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() != arguments) continue;
    const OptionText text = textOf(*option);
    std::string doc = text.doc;
    if (text.head().ends_with(" WORD")) doc += fmt::format(". One of: {}", fmt::join(text.choices, ", "));
    if (text.required && !arguments) doc.insert(0, "Required. ");
    std::string head;
    for (const char c : text.head()) head += c == '|' ? std::string("\\|") : std::string(1, c);
    out += fmt::format("| `{}` | {} |\n", head, markdownCell(doc));
  }
  if (out.empty()) return "";
  return fmt::format("\n| {} | meaning |\n|---|---|\n{}", arguments ? "argument" : "option", out);
}

void addCommand(std::string& out, const CLI::App& command, int depth) {
  const std::string words = wordsOf(command);
  out +=
      fmt::format("\n{} {}\n\n{}.\n\n```text\n{}\n```\n", std::string(static_cast<std::size_t>(depth), '#'),
                  words, command.get_description(), usageOf(command));
  out += optionsTable(command, true) + optionsTable(command, false);
  if (!command.get_footer().empty()) out += "\n" + command.get_footer() + "\n";
  for (const CLI::App* below : commandsBelow(command)) addCommand(out, *below, depth + 1);
}

std::string commandLinePage(const CLI::App& app) {
  std::string out =
      "# Command line\n\n`simreel COMMAND --help` prints the same.\n\n| command | meaning |\n|---|---|\n";
  for (const CLI::App* command : commandsBelow(app))
    out += fmt::format("| [{0}](#simreel-{0}) | {1}. |\n", command->get_name(),
                       markdownCell(command->get_description()));
  out += "\nThese options go with every command:\n" + optionsTable(app, false);
  for (const CLI::App* command : commandsBelow(app)) addCommand(out, *command, 2);
  return out;
}

std::string exitCodesPage() {
  std::string out =
      "# Exit codes\n\nEvery command ends with a code from this table. A message on standard error says "
      "what "
      "happened, where, and what to do.\n\n| code | meaning | what to do |\n|---|---|---|\n";
  for (const ExitMeaning& one : exitMeanings())
    out += fmt::format("| {} | {} | {} |\n", one.code, one.meaning, markdownCell(one.cure));
  return out;
}

std::string environmentPage() {
  std::string out =
      "# Environment variables\n\nAll of them are optional.\n\n| variable | meaning |\n|---|---|\n";
  for (const Variable& one : variables())
    out += fmt::format("| `{}` | {} |\n", one.name, markdownCell(one.meaning));
  return out;
}

std::string messagesPage() {
  std::string out =
      "# Messages and their cures\n\nThe messages that users meet most, by exit code. Capital words stand "
      "for "
      "names and numbers.\n";
  std::string_view code;
  for (const Message& one : messages()) {
    if (one.code != code) {
      code = one.code;
      for (const ExitMeaning& meaning : exitMeanings())
        if (code == meaning.code) out += fmt::format("\n## Exit code {}: {}\n", code, meaning.meaning);
      if (code == "warning") out += "\n## Warnings\n\nThe scene is drawn all the same.\n";
      out += "\n| message | cure |\n|---|---|\n";
    }
    out += fmt::format("| {} | {} |\n", markdownCell(one.shown), markdownCell(one.cure));
  }
  return out;
}

void writePage(const fs::path& folder, const std::string& name, const std::string& text) {
  const fs::path file = folder / (name + ".md");
  if (pathExists(file) && readFile(file, "page") == text) return;
  writeFileAtomically(file, text, NameSync::later);
}

}  // namespace

void writeReference(const fs::path& folder, const CLI::App& app) {
  makeFolders(folder);
  writePage(folder, "README", listMarkdown());
  for (const scene::HelpTitle& title : scene::kindTitles(sim::kinds().list))
    writePage(folder, title.name, pageMarkdown(title.name));
  for (const scene::HelpTitle& title : scene::sectionTitles())
    writePage(folder, title.name, pageMarkdown(title.name));
  writePage(folder, "command-line", commandLinePage(app));
  writePage(folder, "exit-codes", exitCodesPage());
  writePage(folder, "environment", environmentPage());
  writePage(folder, "errors", messagesPage());
  info("{} -> {}", "the reference", folder.string());
}

}  // namespace simreel::cli
