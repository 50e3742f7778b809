#include "cli/help/mistyped.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/wrap.hpp"
#include "cli/help/help_format.hpp"
#include "cli/help/option_text.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

/// Returns the innermost command that was recognized in the command line, such as `report merge`. If there
/// is none, returns the program itself.
const CLI::App& typedCommand(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  return *command;
}

struct KnownFlag {
  std::string name;  ///< name of the flag without dashes
  const CLI::Option* option;
};

/// Returns the long names of the options of a command and of its parents.
std::vector<KnownFlag> flagsOf(const CLI::App& command) {
  std::vector<KnownFlag> flags;
  for (const CLI::App* one = &command; one != nullptr; one = one->get_parent())
    for (const CLI::Option* option : one->get_options())
      for (const std::string& name : option->get_lnames()) flags.push_back({name, option});
  return flags;
}

/// Returns the flag that `word` (without dashes) resembles, or, if `word` has at least 3 letters, the only
/// flag that begins with `word`. Returns null if no flag matches.
const KnownFlag* nearestFlag(const std::string& word, const std::vector<KnownFlag>& flags) {
  if (word.size() < 2) return nullptr;
  std::vector<std::string> names;
  names.reserve(flags.size());
  for (const KnownFlag& flag : flags) names.push_back(flag.name);
  const std::string words = scene::suggestion(word, names);
  for (const KnownFlag& flag : flags)
    if (words == fmt::format("did you mean \"{}\"?", flag.name)) return &flag;
  const KnownFlag* only = nullptr;
  for (const KnownFlag& flag : flags) {
    if (word.size() < 3 || !flag.name.starts_with(word)) continue;
    if (only != nullptr && only->option != flag.option) return nullptr;
    only = &flag;
  }
  return only;
}

std::string unknownFlag(const CLI::App& app, const CLI::App& command, const std::string& typed) {
  const std::string flag = oneLine(typed.substr(0, typed.find('=')));
  const std::string word = flag.substr(std::min(flag.find_first_not_of('-'), flag.size()));
  const std::string page = fmt::format("see `{} --help`", wordsOf(command));
  const auto own = flagsOf(command);
  if (const KnownFlag* near = nearestFlag(word, own))
    return fmt::format("no flag {}; did you mean --{}?\n{}{}", flag, near->name,
                       optionEntry(*near->option, textWidth()), page);
  std::vector<std::string> owners;
  std::string name;
  for (const CLI::App* other : commandsBelow(app))
    if (const auto flags = flagsOf(*other); const KnownFlag* near = nearestFlag(word, flags)) {
      if (!name.empty() && near->name != name) continue;
      name = near->name;
      owners.push_back(other->get_name());
    }
  if (!owners.empty())
    return fmt::format("`{}` has no flag {}; --{} is a flag of {}\n{}", wordsOf(command), flag, name,
                       fmt::join(owners, ", "), page);
  return fmt::format("`{}` has no flag {}; {}", wordsOf(command), flag, page);
}

std::string unknownCommand(const CLI::App& app, const CLI::App& command, const std::string& typed) {
  const std::string word = oneLine(typed);
  const std::string page = fmt::format("see `{} --help`", wordsOf(command));
  if (&command == &app && (lowerExtension(typed) == ".json" || pathExists(typed)))
    return fmt::format("{} is no command; to render that scene: simreel render {} -o NAME_####.png; {}",
                       word, word, page);
  std::vector<std::string> names;
  for (const CLI::App* one : commandsBelow(command)) names.push_back(one->get_name());
  const std::string words = scene::suggestion(word, names);
  const auto near = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
    return words == fmt::format("did you mean \"{}\"?", name);
  });
  if (near == names.end()) return fmt::format("no command \"{}\"; {}; {}", word, words, page);
  const auto* const meant = commandsBelow(command)[static_cast<std::size_t>(near - names.begin())];
  return fmt::format("no command \"{}\"; {}\n{}{}", word, words,
                     listEntry(*near, meant->get_description(), 14, textWidth()), page);
}

/// Returns a message about missing required arguments and options, or an empty text if none is missing.
std::string missing(const CLI::App& command) {
  std::string lines, names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    const OptionText text = textOf(*option);
    names += (names.empty() ? "" : " and ") + (text.argument.empty() ? text.names().back() : text.argument);
    lines += optionEntry(*option, textWidth());
  }
  if (names.empty()) return "";
  return fmt::format("`{}` needs {}\n{}usage: {}; see `{} --help`", wordsOf(command), names, lines,
                     usageOf(command), wordsOf(command));
}

/// Returns a message about an option that was given without its value or twice, or an empty text for any
/// other error.
/// `what`: message of the CLI11 library.
std::string valueless(const CLI::App& command, const std::string& what) {
  const std::string name = what.substr(0, what.find(':'));
  for (const CLI::App* one = &command; one != nullptr; one = one->get_parent())
    for (const CLI::Option* option : one->get_options())
      if (option->check_name(name))
        return fmt::format(
            "{} {}\n{}see `{} --help`", name,
            what.find("At Most") == std::string::npos ? "needs a value" : "is given more than once",
            optionEntry(*option, textWidth()), wordsOf(command));
  return "";
}

/// Returns a message about an option that needs another one or excludes it, or an empty text for any other
/// error. `what`: message of the CLI11 library, such as "--jobs requires --pieces".
std::string idle(const std::string& what) {
  for (const auto& [verb, form] :
       {std::pair<std::string_view, fmt::string_view>(" requires ", "{} has no effect without {}"),
        {" excludes ", "{} and {} exclude each other"}})
    if (const std::size_t at = what.find(verb); at != std::string::npos)
      return fmt::format(fmt::runtime(form), what.substr(0, at), what.substr(at + verb.size()));
  return "";
}

/// Returns a message about a value that is not a number, or an empty text for any other error. `what`:
/// message of the CLI11 library, such as "Could not convert: --turn = x".
std::string unconverted(const CLI::App& command, const std::string& what) {
  const std::size_t colon = what.find(": "), equals = what.find(" = ");
  if (colon == std::string::npos || equals == std::string::npos) return "";
  const std::string name = what.substr(colon + 2, equals - colon - 2);
  for (const CLI::App* one = &command; one != nullptr; one = one->get_parent())
    for (const CLI::Option* option : one->get_options())
      if (option->check_name(name))
        return fmt::format("{} takes a number, not {}\n{}see `{} --help`", name,
                           oneLine(what.substr(equals + 3)), optionEntry(*option, textWidth()),
                           wordsOf(command));
  return "";
}

}  // namespace

std::string explainMistake(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = typedCommand(app);
  const auto unknown = app.remaining(true);
  // Unknown flags are reported before missing arguments, because a mistyped option is often the cause of a
  // missing one.
  const auto flag = std::find_if(unknown.begin(), unknown.end(), [](const std::string& word) {
    return word.size() > 1 && word.starts_with('-') && word != "--";
  });
  if (!commandsBelow(command).empty() && !unknown.empty() && flag != unknown.begin())
    return unknownCommand(app, command, unknown.front());
  if (flag != unknown.end()) return unknownFlag(app, command, *flag);
  const std::string page = fmt::format("; see `{} --help`", wordsOf(command));
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
    if (&command == &app)
      return "simreel needs a command, for example: simreel render flag -o flag.mp4" + page;
    if (std::string text = missing(command); !text.empty()) return text;
    std::vector<std::string> names;
    for (const CLI::App* one : commandsBelow(command)) names.push_back(one->get_name());
    if (!names.empty())
      return fmt::format("`{}` needs a command: {}{}", wordsOf(command), fmt::join(names, ", "), page);
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    if (std::string text = valueless(command, error.what()); !text.empty()) return text;
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr ||
      dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr)
    if (const std::string text = idle(error.what()); !text.empty()) return text + page;
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr)
    if (std::string text = unconverted(command, error.what()); !text.empty()) return text;
  if (!unknown.empty())
    return fmt::format("`{}` takes no {}; usage: {}{}", wordsOf(command), oneLine(unknown.front()),
                       usageOf(command), page);
  return error.what() + page;
}

}  // namespace simreel::cli
