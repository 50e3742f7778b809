#pragma once
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace simreel::cli {

/// Returns a message about a command line that cannot be parsed: the error, a suggestion, and the help of
/// the intended option. The text has several lines and no final newline.
[[nodiscard]] std::string explainMistake(const CLI::App& app, const CLI::ParseError& error);

}  // namespace simreel::cli
