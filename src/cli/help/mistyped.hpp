#pragma once
#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace simreel::cli {

/// Message about a command line that cannot be read: the mistake, what may have been meant, and that
/// option's line of help. Several lines, without a newline at the end.
[[nodiscard]] std::string explainMistake(const CLI::App& app, const CLI::ParseError& error);

}  // namespace simreel::cli
