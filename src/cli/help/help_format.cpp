#include "cli/help/help_format.hpp"

#include "base/wrap.hpp"
#include "cli/help/exit_codes.hpp"
#include "cli/help/option_text.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

constexpr std::size_t optionColumn = 28;
constexpr std::size_t commandColumn = 14;

/// Wraps each line to `width` columns. Lines that begin with a space are examples and are not wrapped.
std::string wrappedLines(const std::string& text, std::size_t width) {
  std::string out;
  for (const std::string& line : CLI::detail::split(text, '\n'))
    out += (line.starts_with(' ') ? line : wrapped(line, width)) + "\n";
  return out;
}

std::string optionsText(const CLI::App& app, bool arguments, std::size_t width) {
  std::string out;
  for (const CLI::Option* option : app.get_options())
    if (option->get_positional() == arguments && !option->get_group().empty())
      out += optionEntry(*option, width);
  return out.empty() ? "" : fmt::format("\n{}:\n{}", arguments ? "Arguments" : "Options", out);
}

std::string commandsText(const CLI::App& app, std::size_t width) {
  std::vector<std::string> groups;
  for (const CLI::App* command : commandsBelow(app))
    if (std::find(groups.begin(), groups.end(), command->get_group()) == groups.end())
      groups.push_back(command->get_group());
  std::string out;
  for (const std::string& group : groups) {
    out += fmt::format("\n{}:\n", group == "Subcommands" ? "Commands" : group);
    for (const CLI::App* command : commandsBelow(app))
      if (command->get_group() == group)
        out += listEntry(command->get_name(), command->get_description(), commandColumn, width);
  }
  return out;
}

class HelpFormat final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string /*name*/,
                        CLI::AppFormatMode /*mode*/) const override {
    const std::size_t width = textWidth();
    std::string out = wrappedLines(app->get_description() + ".", width);
    out += "\n" + wrapped("Usage: " + usageOf(*app), width, 7) + "\n";
    const bool isProgram = app->get_parent() == nullptr;
    if (isProgram) out += commandsText(*app, width);
    out += optionsText(*app, true, width) + optionsText(*app, false, width);
    if (!isProgram) out += commandsText(*app, width);
    if (!app->get_footer().empty()) out += "\n" + wrappedLines(app->get_footer(), width);
    return out;
  }
};

struct Group {
  const char* name;
  std::vector<const char*> commands;
};

std::string examplesText() {
  std::string out =
      "Where to start:\n"
      "  simreel render flag -o flag.mp4               # a shipped scene as a video\n"
      "  simreel new cloth > cloth.json                # a commented scene to change\n"
      "  simreel render cloth.json -o cloth_####.png   # its frames as numbered pictures\n"
      "  simreel serve cloth.json                      # the scene in a browser while you edit it\n"
      "  simreel list cloth                            # every parameter of cloth\n"
      "\n"
      "`simreel COMMAND --help` describes one command; `simreel list` names what a scene can hold.\n"
      "\n"
      "Exit codes:\n";
  for (const ExitMeaning& one : exitMeanings()) out += fmt::format("  {:<9}{}\n", one.code, one.meaning);
  return out + "\n`simreel doctor` says whether this machine can render.";
}

}  // namespace

std::string optionEntry(const CLI::Option& option, std::size_t width) {
  const OptionText text = textOf(option);
  std::string doc = text.doc;
  if (text.head().ends_with(" WORD") && !text.choices.empty())
    doc += fmt::format(". One of: {}", fmt::join(text.choices, ", "));
  if (text.required && text.argument.empty()) doc = "(required) " + doc;
  return listEntry(text.head(), doc, optionColumn, width);
}

void useHelpFormat(CLI::App& app) {
  app.formatter(std::make_shared<HelpFormat>());
}

void groupCommands(CLI::App& app) {
  app.description("Renders GPU simulations to pictures and videos, without a display");
  app.footer(examplesText());
  const std::array<Group, 5> groups = {{
      {"Render", {"render", "serve", "bake"}},
      {"Write a scene", {"new", "list", "explain", "validate"}},
      {"Test", {"test", "accept", "report", "diff", "reproduce", "trace", "bisect"}},
      {"Render many", {"sweep", "pieces"}},
      {"Tools", {"kernels", "doctor", "bench", "schema"}},
  }};
  for (const Group& group : groups)
    for (const char* name : group.commands) app.get_subcommand(name)->group(group.name);
}

}  // namespace simreel::cli
