#pragma once
#include <filesystem>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Writes the reference as Markdown. It has one page for each kind and section, and pages for the command
/// line, exit codes, environment variables, and messages with their solutions. Does not write files whose
/// bytes would not change.
void writeReference(const std::filesystem::path& folder, const CLI::App& app);

}  // namespace simreel::cli
