#include "cli/help/option_text.hpp"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::cli {

namespace {

/// Returns the range in a type's description, or an empty text if none exists.
std::string rangeIn(const std::string& type) {
  const auto open = type.find(" in [");
  const auto close = type.rfind(']');
  if (open == std::string::npos || close == std::string::npos || close < open) return "";
  const auto bounds = CLI::detail::split(type.substr(open + 5, close - open - 5), ' ');
  if (bounds.size() != 3) return "";
  return fmt::format("{} to {:.15g}", bounds[0], std::stod(bounds[2]));
}

/// Returns the placeholder for the value of an option with these long names.
std::string placeholder(const std::vector<std::string>& longs) {
  static const std::map<std::string, std::string> words = {
      {"output", "PATH"},
      {"frames", "FRAMES"},
      {"device", "DEVICE"},
      {"memory-path", "storage|texel"},
      {"progress", "WORD"},
      {"jobs", "N"},
      {"rule", "RULE"},
      {"from", "FILE"},
      {"checkpoint-at", "FRAMES"},
      {"sbatch", "OPTIONS"},
      {"scratch", "FOLDER"},
      {"report", "FOLDER"},
      {"junit", "FILE"},
      {"json", "FILE"},
      {"markdown", "FILE"},
      {"reason", "WORDS"},
      {"profile", "NAME"},
      {"expected", "FOLDER"},
      {"actual", "FOLDER"},
      {"run", "COMMAND"},
      {"rules", "FILE"},
      {"mask", "FILE"},
      {"filter", "PATTERN"},
      {"shard", "K/N"},
      {"object", "NAME"},
      {"fields", "NAME,..."},
      {"only", "PATTERN"},
      {"scene", "FILE"},
      {"scenes", "FOLDER"},
      {"beside", "PATH=VALUE"},
      {"bind", "ADDRESS"},
      {"look", "WORD"},
      {"vary", "PATH=VALUES"},
      {"baseline", "FILE"},
  };
  for (const std::string& name : longs)
    if (const auto word = words.find(name); word != words.end()) return word->second;
  return "TEXT";
}

void takeValue(const CLI::Option& option, OptionText& text) {
  const std::string type = option.get_type_name();
  const auto open = type.find('{');
  const auto close = type.rfind('}');
  if (open != std::string::npos && close != std::string::npos) {  // The allowed words come from
                                                                  // CLI::IsMember or type_name().
    text.choices = CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
    text.value = fmt::format("{}", fmt::join(text.choices, "|"));
    std::erase(text.choices, "NAME");  // NAME stands for any name.
    return;
  }
  const std::string plain = type.substr(0, type.find(':'));
  text.value = plain == "TEXT"                     ? placeholder(text.longs)
               : plain == "INT" || plain == "UINT" ? "N"
               : plain == "FLOAT"                  ? "NUMBER"
                                                   : plain;
}

}  // namespace

std::vector<std::string> OptionText::names() const {
  std::vector<std::string> all;
  for (const std::string& name : shorts) all.push_back("-" + name);
  for (const std::string& name : longs) all.push_back("--" + name);
  return all;
}

std::string OptionText::head() const {
  if (!argument.empty()) return argument + (several ? "..." : "");
  constexpr std::size_t widest = 24;
  const bool words = !choices.empty() && value.size() > widest;
  return fmt::format("{}{}{}", fmt::join(names(), ", "), value.empty() ? "" : " ", words ? "WORD" : value);
}

OptionText textOf(const CLI::Option& option) {
  OptionText text;
  text.shorts = option.get_snames();
  text.longs = option.get_lnames();
  text.required = option.get_required();
  if (option.get_positional()) text.argument = option.get_name();
  text.doc = option.get_description();
  text.several = option.get_items_expected_max() > 1;
  if (option.get_items_expected_max() == 0) return text;
  takeValue(option, text);
  if (option.get_items_expected_min() == 0) text.value = "[" + text.value + "]";
  const std::string range = rangeIn(option.get_type_name());
  if (!range.empty()) text.doc += fmt::format(" ({})", range);
  if (!option.get_default_str().empty())
    text.doc += fmt::format(" (default: {})", option.get_default_str());
  return text;
}

std::string wordsOf(const CLI::App& command) {
  return command.get_parent() == nullptr ? command.get_name()
                                         : wordsOf(*command.get_parent()) + " " + command.get_name();
}

std::string usageOf(const CLI::App& command) {
  std::string usage = wordsOf(command);
  const auto below = commandsBelow(command);
  if (!below.empty() && command.get_parent() == nullptr) return usage + " COMMAND [OPTIONS]";
  for (const CLI::Option* option : command.get_options()) {
    const OptionText text = textOf(*option);
    if (option->get_positional())
      usage += text.required ? " " + text.head() : " [" + text.head() + "]";
    else if (text.required)
      usage += " " + text.names().front() + " " + text.value;
  }
  usage += " [OPTIONS]";
  return below.empty() ? usage
                       : usage + (command.get_require_subcommand_min() > 0 ? " COMMAND" : " [COMMAND]");
}

std::vector<const CLI::App*> commandsBelow(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* one) { return !one->get_name().empty(); });
}

}  // namespace simreel::cli
