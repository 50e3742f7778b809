#include "cli/test/outputs.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"
#include "base/process.hpp"
#include "golden/pictures/picture_folder.hpp"
#include "golden/report/github.hpp"
#include "golden/report/html.hpp"
#include "golden/report/json.hpp"
#include "golden/report/junit.hpp"
#include "golden/report/markdown.hpp"
#include "golden/report/text.hpp"
#include "golden/report/thumbnail.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace fs = std::filesystem;

namespace {

/// Removes the paths of pictures from a result, for a JSON report outside the report's folder. The command
/// `accept` reads only files inside that folder.
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

/// Returns the absolute path of a folder without a trailing slash. An empty `folder` means the current
/// folder.
fs::path wholePath(const fs::path& folder) {
  const fs::path whole = (fs::current_path() / folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

/// Returns the function that makes the `src` attribute of an image in Markdown. `folder`: folder in which
/// the report stores its pictures.
golden::PictureAddress pictureAddress(const std::string& how, const fs::path& folder,
                                      const fs::path& from) {
  if (how == "none") return {};
  if (how == "data")
    return [folder](const std::string& picture) {
      return golden::dataAddress(folder / picture, golden::thumbnailWidth);
    };
  std::string before = how;
  if (how == "files")
    before = golden::addressOf(wholePath(folder).lexically_relative(wholePath(from)).generic_string());
  if (!before.empty() && !before.ends_with('/')) before += '/';
  return [before](const std::string& picture) { return before + golden::addressOf(picture); };
}

/// Returns the report's folder relative to the project's folder on GitLab or Jenkins, or the absolute path
/// if the folder is outside the project.
fs::path folderInProject(const fs::path& folder) {
  fs::path project;
  for (const char* name : {"WORKSPACE", "CI_PROJECT_DIR"})
    // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
    if (const char* given = std::getenv(name); given != nullptr && *given != '\0') project = given;
  const fs::path whole = wholePath(folder);
  const fs::path below = whole.lexically_relative(wholePath(project));
  return below.empty() || *below.begin() == ".." ? whole : below;
}

void writeGithub(const golden::SuiteResult& suite, const golden::PictureAddress& address) {
  // fwrite() is used because printText() would escape the annotation commands.
  const std::string commands = golden::githubAnnotations(suite);
  static_cast<void>(std::fwrite(commands.data(), 1, commands.size(), stdout));
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment is only read.
  const char* place = std::getenv("GITHUB_STEP_SUMMARY");
  if (place == nullptr || *place == '\0') return;
  // The file is opened for appending, because earlier steps of the job may have written to the summary.
  std::FILE* file = std::fopen(place, "a");
  const std::string text = golden::markdownSummary(suite, address);
  const bool written = file != nullptr && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  if ((file != nullptr && std::fclose(file) != 0) || !written)
    fail(ExitCode::inputOutput, "cannot write the job summary to {}", place);
}

bool colored() {
  return ::isatty(STDOUT_FILENO) == 1;
}

/// Returns the common folder of all scenes outside the current folder. Returns an empty path if there are
/// none.
fs::path folderOutside(const golden::SuiteResult& suite) {
  fs::path common;
  for (const golden::SceneResult& scene : suite.scenes) {
    if (scene.candidate.empty() || liesBelow(scene.file, {})) continue;
    const fs::path folder = fs::path(scene.file).parent_path();
    if (common.empty()) common = folder;
    while (common.has_relative_path() && !liesBelow(folder, common)) common = common.parent_path();
  }
  return common;
}

/// Returns the command line that accepts this run. It contains --expected if baselines are outside the
/// current folder, and --scenes if scenes are outside of it.
std::string acceptCommand(const golden::SuiteResult& suite, const std::string& reportFile) {
  std::string command = "simreel accept " + inShellQuotes(reportFile);
  if (const fs::path expected = suite.expected;
      expected.is_absolute() || suite.expected.find("..") != std::string::npos)
    command += " --expected " + inShellQuotes(suite.expected);
  if (suite.unit == "scene")
    if (const fs::path folder = folderOutside(suite); !folder.empty())
      command += " --scenes " + inShellQuotes(folder.string());
  return command;
}

}  // namespace

void TestOutputs::add(CLI::App& command) {
  command.add_option("--report", report, "Folder for the HTML report, its pictures and report.json");
  addFiles(command);
}

void TestOutputs::addFiles(CLI::App& command) {
  command.add_option("--junit", junit, "JUnit XML file");
  command.add_option("--json", json, "JSON report; without --report, pictures of failures go beside it");
  command.add_option("--markdown", markdown,
                     "A summary with small pictures, for a comment or a page; without --report and --json, "
                     "pictures of failures go beside it");
  command.add_option("--markdown-pictures", pictures,
                     "How the text refers to pictures: files (the default); data, within the text (the "
                     "default of job summaries, though github.com leaves those out); none; or the address "
                     "(https://...) at which the report's folder is served");
  command.add_flag("--github", github, "Print annotations and write the job summary of GitHub Actions");
}

fs::path TestOutputs::folder() const {
  return report.empty() ? fs::path(json.empty() ? markdown : json).parent_path() : fs::path(report);
}

fs::path TestOutputs::artifacts() const {
  if (!report.empty()) return fs::path(report) / "files";
  const std::string& file = json.empty() ? markdown : json;
  return file.empty() ? fs::path() : fs::path(fs::path(file).replace_extension().string() + "-files");
}

void TestOutputs::check() const {
  if (!pictures.empty() && markdown.empty() && !github)
    fail(ExitCode::usage, "--markdown-pictures has no effect without --markdown or --github");
  if (!pictures.empty() && pictures != "files" && pictures != "data" && pictures != "none" &&
      !pictures.starts_with("http://") && !pictures.starts_with("https://"))
    fail(ExitCode::usage,
         "--markdown-pictures takes files, data, none or an address that begins with https://, not \"{}\"",
         pictures);
  if (pictures.find_first_of("\"<> \n") != std::string::npos)
    fail(ExitCode::usage,
         "--markdown-pictures takes an address without spaces, quotes and brackets, not \"{}\"", pictures);
}

void TestOutputs::prepare() const {
  check();
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

void TestOutputs::print(const golden::SceneResult& scene, const std::string& unit, bool allowFlaky) const {
  if (verbosity() == Verbosity::quiet) {
    if (golden::isFailure(scene.status, allowFlaky))
      errorLines(golden::sceneLine(scene, false, folder(), unit));
    return;
  }
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
  const fs::path place = folder();
  const bool kept = !artifacts().empty();
  if (kept && pathExists(artifacts())) golden::markReport(artifacts());
  if (!junit.empty())
    writeFileAtomically(junit, golden::junitText(suite, kept ? folderInProject(place) : fs::path()));
  if (!markdown.empty()) {
    const fs::path beside = fs::path(markdown).parent_path();
    makeFolders(beside);
    const auto address = pictureAddress(pictures.empty() ? "files" : pictures, place, beside);
    writeFileAtomically(markdown, golden::markdownSummary(suite, address));
  }
  // A job summary cannot refer to files, so pictures are embedded by default.
  if (github)
    writeGithub(suite, pictureAddress(pictures.empty()      ? "data"
                                      : pictures == "files" ? "none"
                                                            : pictures,
                                      place, {}));
  if (verbosity() != Verbosity::quiet)
    printPainted(golden::closingText(suite, colored(), report));
  else if (suite.strict)
    for (const golden::Stale& stale : suite.stale)
      if (!stale.removed) errorLine(stale.path + ": " + stale.message);
}

}  // namespace simreel::cli
