#pragma once
#include <filesystem>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Writes the reference as Markdown: one page for each kind and section, the command line, exit codes,
/// environment variables, and messages with their solutions. Files whose bytes would not change are not
/// written.
void writeReference(const std::filesystem::path& folder, const CLI::App& app);

}  // namespace simreel::cli
