#pragma once
#include <filesystem>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Writes the reference as Markdown: a page for each kind and section, the command line, exit codes,
/// environment variables, and messages with their cures. Files of the same bytes are left alone.
void writeReference(const std::filesystem::path& folder, const CLI::App& app);

}  // namespace simreel::cli
