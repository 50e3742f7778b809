#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace simreel::cli {

/// One option, or one argument without a name, as help, man page and reference print it.
struct OptionText {
  std::vector<std::string> shorts, longs;  ///< without their dashes
  std::string argument;                    ///< of an argument: its name; empty: an option
  std::string doc;                         ///< with default and range
  std::string value;                       ///< placeholder of what it takes; empty: nothing
  std::vector<std::string> choices;        ///< the words it takes, where only some are allowed
  bool required = false;
  bool several = false;  ///< an argument that takes more than one value

  /// "-o", "--output"
  [[nodiscard]] std::vector<std::string> names() const;
  /// "-o, --output PATH", or "scenes..."
  [[nodiscard]] std::string head() const;
};

[[nodiscard]] OptionText textOf(const CLI::Option& option);
/// The words that a user types for a command: "simreel report merge".
[[nodiscard]] std::string wordsOf(const CLI::App& command);
/// "simreel render [OPTIONS] scene"
[[nodiscard]] std::string usageOf(const CLI::App& command);
/// Its subcommands, in order.
[[nodiscard]] std::vector<const CLI::App*> commandsBelow(const CLI::App& command);

}  // namespace simreel::cli
