#pragma once
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace simreel::cli {

/// Makes the program and all its commands print help in this project's format, wrapped to the terminal
/// width. Must run before commands are added, because commands inherit the formatter.
void useHelpFormat(CLI::App& app);
/// Gives the program its description, examples and exit codes. Assigns each command to its group.
void groupCommands(CLI::App& app);
/// Returns one option as `--help` prints it, in lines of at most `width` columns.
[[nodiscard]] std::string optionEntry(const CLI::Option& option, std::size_t width);

}  // namespace simreel::cli
