#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace simreel::cli {

/// One option, or one positional argument, with the texts that the help, the man page and the reference
/// print.
struct OptionText {
  std::vector<std::string> shorts, longs;  ///< names of the option without dashes
  std::string argument;                    ///< name of a positional argument; empty for an option
  std::string doc;                         ///< description of the option, with default and range
  std::string value;                       ///< placeholder of the value; empty for a flag without a value
  std::vector<std::string> choices;        ///< allowed words; empty if any value is allowed
  bool required = false;
  bool several = false;  ///< true for an argument that accepts several values

  /// Returns the names with dashes: "-o", "--output".
  [[nodiscard]] std::vector<std::string> names() const;
  /// Returns the heading: "-o, --output PATH", or "scenes...".
  [[nodiscard]] std::string head() const;
};

[[nodiscard]] OptionText textOf(const CLI::Option& option);
/// Returns the words that a user types for a command: "simreel report merge".
[[nodiscard]] std::string wordsOf(const CLI::App& command);
/// Returns the usage line: "simreel render [OPTIONS] scene".
[[nodiscard]] std::string usageOf(const CLI::App& command);
/// Returns the subcommands of a command, in order.
[[nodiscard]] std::vector<const CLI::App*> commandsBelow(const CLI::App& command);

}  // namespace simreel::cli
