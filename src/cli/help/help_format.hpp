#pragma once
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace simreel::cli {

/// Makes the program and all commands below it print help of ours, which wraps to the terminal. Before any
/// command is added, which inherits it.
void useHelpFormat(CLI::App& app);
/// Gives the program its description, examples and exit codes, and each command its group.
void groupCommands(CLI::App& app);
/// One option as `--help` prints it, in lines of at most `width` columns.
[[nodiscard]] std::string optionEntry(const CLI::Option& option, std::size_t width);

}  // namespace simreel::cli
