#include "cli/test/outputs.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/process.hpp"
#include "golden/report/github.hpp"
#include "golden/report/html.hpp"
#include "golden/report/json.hpp"
#include "golden/report/junit.hpp"
#include "golden/report/text.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace fs = std::filesystem;

namespace {

/// What accept reads is inside the report's folder; a JSON report elsewhere points nowhere.
golden::SuiteResult forElsewhere(golden::SuiteResult suite) {
  for (golden::SceneResult& scene : suite.scenes) {
    scene.candidate.clear();
    for (golden::FrameResult& frame : scene.frames) {
      frame.others.clear();
      for (std::string* path :
           {&frame.expectedImage, &frame.actualImage, &frame.differenceImage, &frame.flipImage})
        path->clear();
    }
  }
  return suite;
}

void writeGithub(const golden::SuiteResult& suite) {
  // The one text that is made of commands.
  const std::string commands = golden::githubAnnotations(suite);
  static_cast<void>(std::fwrite(commands.data(), 1, commands.size(), stdout));
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  const char* place = std::getenv("GITHUB_STEP_SUMMARY");
  if (place == nullptr || *place == '\0') return;
  // Earlier steps of the job may have written there.
  std::FILE* file = std::fopen(place, "a");
  const std::string text = golden::githubSummary(suite);
  const bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if ((file != nullptr && std::fclose(file) != 0) || !written)
    fail(ExitCode::inputOutput, "cannot write the job summary to {}", place);
}

bool colored() {
  return ::isatty(STDOUT_FILENO) == 1;
}

/// What accepts a run whose baselines are not below the folder that it ran in has to be told their folder.
std::string acceptCommand(const golden::SuiteResult& suite, const std::string& reportFile) {
  std::string command = "simreel accept " + inShellQuotes(reportFile);
  if (const fs::path expected = suite.expected;
      expected.is_absolute() || suite.expected.find("..") != std::string::npos)
    command += " --expected " + inShellQuotes(suite.expected);
  return command;
}

}  // namespace

void TestOutputs::add(CLI::App& command) {
  command.add_option("--report", report, "Folder for the HTML report, its pictures and report.json");
  command.add_option("--junit", junit, "JUnit XML file");
  command.add_option("--json", json, "JSON report; without --report, pictures of failures go beside it");
  command.add_flag("--github", github, "Print annotations and write the job summary of GitHub Actions");
}

fs::path TestOutputs::folder() const {
  return report.empty() ? fs::path(json).parent_path() : fs::path(report);
}

fs::path TestOutputs::artifacts() const {
  if (!report.empty()) return fs::path(report) / "files";
  return json.empty() ? fs::path() : fs::path(fs::path(json).replace_extension().string() + "-files");
}

void TestOutputs::prepare() const {
  if (report.empty()) return;
  std::error_code error;
  const fs::path place = report;
  if (fs::exists(place, error) && !fs::is_directory(place, error))
    fail(ExitCode::usage, "--report takes a folder, and {} is a file", report);
  if (fs::exists(place, error) && !fs::is_empty(place, error) && !fs::exists(place / "report.json", error))
    fail(ExitCode::usage, "the folder {} is not empty and holds no report; give --report another one",
         report);
  fs::remove_all(artifacts(), error);
  makeFolders(place);
}

void TestOutputs::show(const golden::SceneResult& scene, const std::string& unit) const {
  if (verbosity() == Verbosity::quiet) return;
  printPainted(golden::sceneLine(scene, colored(), folder(), unit));
  std::fflush(stdout);
}

void TestOutputs::write(golden::SuiteResult& suite) const {
  const std::string file = report.empty() ? json : (fs::path(report) / "report.json").string();
  if (std::any_of(suite.scenes.begin(), suite.scenes.end(),
                  [](const golden::SceneResult& scene) { return !scene.candidate.empty(); }))
    suite.acceptCommand = acceptCommand(suite, file);
  if (!report.empty()) {
    writeFileAtomically(file, golden::reportText(suite));
    golden::writeHtmlReport(report, suite);
  }
  if (!json.empty())
    writeFileAtomically(json, golden::reportText(report.empty() ? suite : forElsewhere(suite)));
  if (!junit.empty()) writeFileAtomically(junit, golden::junitText(suite));
  if (github) writeGithub(suite);
  if (verbosity() != Verbosity::quiet) printPainted(golden::closingText(suite, colored(), report));
}

}  // namespace simreel::cli
