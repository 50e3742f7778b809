#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Where the results of a test go.
struct TestOutputs {
  std::string report, junit, json, markdown;
  /// How pictures get into Markdown: "files", "data", "none" or an address that the report is served at;
  /// empty: files, and data in a job summary.
  std::string pictures;
  bool github = false;
  void add(CLI::App& command);
  /// All of them but the report's folder.
  void addFiles(CLI::App& command);

  /// Of report.json, which the paths of images are relative to; empty: images are not kept.
  [[nodiscard]] std::filesystem::path folder() const;
  /// Where pictures of failures go: <report>/files, or beside the JSON report or the Markdown; empty:
  /// nowhere.
  [[nodiscard]] std::filesystem::path artifacts() const;
  /// Removes an earlier report. Throws UserError(usage) for a folder that holds something else.
  void prepare() const;
  /// Prints a result as it comes.
  void show(const golden::SceneResult& scene, const std::string& unit, bool allowFlaky) const;
  /// Throws UserError(usage).
  void check() const;
  /// Writes all that was asked for and prints the closing lines.
  void write(golden::SuiteResult& suite) const;
};

}  // namespace simreel::cli
