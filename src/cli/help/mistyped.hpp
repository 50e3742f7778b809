#pragma once
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace simreel::cli {

/// Returns the message about a command line that cannot be parsed: the error, a suggestion, and the help of
/// the option meant. Several lines without a final newline.
[[nodiscard]] std::string explainMistake(const CLI::App& app, const CLI::ParseError& error);

}  // namespace simreel::cli
