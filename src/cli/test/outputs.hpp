#pragma once
#include "golden/result.hpp"

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace simreel::cli {

/// Output files of a test run.
struct TestOutputs {
  std::string report, junit, json, markdown;
  /// Form of pictures in Markdown: "files", "data", "none" or a URL that serves the report's folder. If
  /// empty, the form is "data" in a job summary and "files" elsewhere.
  std::string pictures;
  bool github = false;
  void add(CLI::App& command);
  /// Adds all options except --report.
  void addFiles(CLI::App& command);

  /// Returns the folder of report.json. The paths of images are relative to this folder. An empty path
  /// means that images are not kept.
  [[nodiscard]] std::filesystem::path folder() const;
  /// Returns the folder for pictures of failures: <report>/files, or a folder next to the JSON report or
  /// the Markdown file. An empty path means that pictures are not written.
  [[nodiscard]] std::filesystem::path artifacts() const;
  /// Removes an earlier report. Throws UserError(usage) if the folder contains other files.
  void prepare() const;
  /// Prints one result. Called as soon as the result is known.
  void print(const golden::SceneResult& scene, const std::string& unit, bool allowFlaky) const;
  /// Checks the options. Throws UserError(usage).
  void check() const;
  /// Writes all requested files and prints the final lines.
  void write(golden::SuiteResult& suite) const;
};

}  // namespace simreel::cli
