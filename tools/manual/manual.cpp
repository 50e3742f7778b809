// Prints the man page or a shell's completion script, from the same declarations as --help:
//
//     simreel_manual man|bash|zsh|fish
#include "base/version.hpp"
#include "cli/commands.hpp"
#include "cli/help/exit_codes.hpp"
#include "cli/help/option_text.hpp"
#include "cli/list/environment.hpp"

#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/ranges.h>

namespace {

using Flag = simreel::cli::OptionText;

struct Command {
  std::string name, doc, footer;
  std::string arguments;  ///< positional arguments, such as "scenes..."
  std::vector<Flag> flags;

  [[nodiscard]] std::vector<std::string> flagNames() const {
    std::vector<std::string> all;
    for (const Flag& flag : flags)
      for (const std::string& word : flag.names()) all.push_back(word);
    return all;
  }
};

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

Command commandOf(const CLI::App& app) {
  Command command{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options()) {
    const Flag flag = simreel::cli::textOf(*option);
    if (flag.argument.empty())
      command.flags.push_back(flag);
    else
      command.arguments += flag.required ? " " + flag.head() : " [" + flag.head() + "]";
  }
  return command;
}

/// Returns one entry for a command and all its subcommands. The arguments of a subcommand follow its name,
/// as in "report merge reports...".
Command wholeCommandOf(const CLI::App& app) {
  Command command = commandOf(app);
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) {
    const Command part = commandOf(*below);
    command.arguments += " " + part.name + part.arguments;
    command.doc += ". " + part.name + ": " + part.doc;
    command.flags.insert(command.flags.end(), part.flags.begin(), part.flags.end());
  }
  return command;
}

/// Returns the program's commands. The first entry has no name and contains the flags that are allowed
/// anywhere.
std::vector<Command> commandsOf(const CLI::App& app) {
  std::vector<Command> all = {commandOf(app)};
  all.front().name.clear();
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    all.push_back(wholeCommandOf(*command));
  return all;
}

// Escapes text for groff(7). A backslash starts an escape sequence, a dot or quote at the start of a line
// starts a request, and an unescaped - is printed as a hyphen.
std::string roff(const std::string& text) {
  std::string safe = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  safe = replaced(replaced(safe, "\n.", "\n\\&."), "\n'", "\n\\&'");
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

std::string roffFlag(const Flag& flag) {
  std::string text = ".TP\n";
  for (const std::string& name : flag.names())
    text += (text.size() > 4 ? ", \\fB" : "\\fB") + roff(name) + "\\fR";
  if (!flag.value.empty()) text += " \\fI" + roff(flag.value) + "\\fR";
  return text + "\n" + roff(flag.doc) + "\n";
}

std::string man(const std::vector<Command>& commands) {
  const Command& program = commands.front();
  std::string text = fmt::format(
      ".TH SIMREEL 1 \"\" \"simreel {}\"\n.SH NAME\nsimreel \\- {}\n.SH SYNOPSIS\n.B simreel\n"
      ".I COMMAND\n[options]\n.SH OPTIONS\n",
      roff(simreel::version()), roff(program.doc));
  for (const Flag& flag : program.flags) text += roffFlag(flag);
  text += ".SH COMMANDS\n";
  for (const Command& command : std::span(commands).subspan(1)) {
    text +=
        fmt::format(".SS \"{}{}\"\n{}.\n", roff(command.name), roff(command.arguments), roff(command.doc));
    for (const Flag& flag : command.flags)
      if (flag.longs != std::vector<std::string>{"help"}) text += roffFlag(flag);
    if (!command.footer.empty()) text += ".PP\n" + roff(command.footer) + "\n";
  }
  text += ".SH EXIT STATUS\n";
  for (const simreel::cli::ExitMeaning& one : simreel::cli::exitMeanings())
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(one.code), roff(one.meaning));
  text += ".SH ENVIRONMENT\n";
  for (const simreel::cli::Variable& one : simreel::cli::variables())
    text += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(one.name), roff(one.meaning));
  return text +
         ".SH SEE ALSO\nThe guide, cookbook and reference in share/doc/simreel/guide; "
         "\\fBsimreel list\\fR.\n";
}

std::string quoted(const std::string& text) {
  return "'" + replaced(text, "'", "'\\''") + "'";
}

std::vector<std::string> namesOf(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : std::span(commands).subspan(1)) names.push_back(command.name);
  return names;
}

/// Returns the completion script for bash. If it offers nothing, the shell completes file names.
std::string bash(const std::vector<Command>& commands) {
  const auto names = namesOf(commands);
  std::string values, flags;
  for (const Command& command : commands) {
    const std::string place = command.name.empty() ? "''" : command.name;
    flags += fmt::format("    {}) words='{}' ;;\n", place, fmt::join(command.flagNames(), " "));
    for (const Flag& flag : command.flags)
      for (const std::string& name : flag.names())
        if (!flag.value.empty())
          values +=
              fmt::format("    '{} {}') words='{}' ;;\n", command.name, name, fmt::join(flag.choices, " "));
  }
  return fmt::format(R"(# bash completion for simreel
_simreel() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} command= word words=none
  for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
    case $word in {0}) command=$word; break ;; esac
  done
  COMPREPLY=()
  case "$command ${{COMP_WORDS[COMP_CWORD-1]}}" in
{1}  esac
  if [ "$words" = none ]; then
    [[ -z $command || $current == -* ]] || return
    case $command in
{2}    esac
    [ -n "$command" ] || words+=' {3}'
  fi
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o default -F _simreel simreel
)",
                     fmt::join(names, "|"), values, flags, fmt::join(names, " "));
}

/// Returns flags in the syntax of zsh's _arguments. Special characters in descriptions are escaped.
std::string zshFlags(const Command& command) {
  std::string text;
  for (const Flag& flag : command.flags) {
    const std::string doc = replaced(replaced(replaced(flag.doc, "[", "\\["), "]", "\\]"), ":", "\\:");
    for (const std::string& name : flag.names()) {
      const std::string value = flag.value.empty() ? ""
                                : flag.choices.empty()
                                    ? ":value:_files"
                                    : fmt::format(":value:({})", fmt::join(flag.choices, " "));
      text += fmt::format(" \\\n        {}", quoted("*" + name + "[" + doc + "]" + value));
    }
  }
  return text;
}

std::string zsh(const std::vector<Command>& commands) {
  std::string descriptions, cases;
  for (const Command& command : std::span(commands).subspan(1)) {
    descriptions += " " + quoted(command.name + ":" + command.doc);
    cases += fmt::format("      {}) _arguments{}{} \\\n        '*:file:_files' ;;\n", command.name,
                         zshFlags(commands.front()), zshFlags(command));
  }
  return fmt::format(R"(#compdef simreel
_simreel() {{
  local -a commands=({0})
  local state
  _arguments{1} \
        '1:command:->command' '*::argument:->argument'
  case $state in
    command) _describe command commands ;;
    argument) case $words[1] in
{2}    esac ;;
  esac
}}
_simreel "$@"
)",
                     descriptions, zshFlags(commands.front()), cases);
}

std::string fish(const std::vector<Command>& commands) {
  std::string text = "# fish completion for simreel\n";
  for (const Command& command : commands) {
    if (!command.name.empty())
      text += fmt::format("complete -c simreel -f -n __fish_use_subcommand -a {} -d {}\n", command.name,
                          quoted(command.doc));
    for (const Flag& flag : command.flags) {
      text += "complete -c simreel";
      if (!command.name.empty()) text += fmt::format(" -n '__fish_seen_subcommand_from {}'", command.name);
      for (const std::string& name : flag.shorts) text += " -s " + name;
      for (const std::string& name : flag.longs) text += " -l " + name;
      if (!flag.value.empty())
        text += flag.choices.empty() ? " -r" : fmt::format(" -x -a '{}'", fmt::join(flag.choices, " "));
      text +=
          fmt::format(" -d {}\n", replaced(replaced(quoted(flag.doc), "\\", "\\\\"), "'\\\\''", "'\\''"));
    }
  }
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app;
  simreel::cli::addCommands(app);
  const std::vector<Command> commands = commandsOf(app);
  const std::string form = argc == 2 ? argv[1] : "";
  const auto print = form == "man"    ? man
                     : form == "bash" ? bash
                     : form == "zsh"  ? zsh
                     : form == "fish" ? fish
                                      : nullptr;
  if (print == nullptr) return 2;
  const std::string text = print(commands);
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0 ? 0
                                                                                                     : 6;
}
