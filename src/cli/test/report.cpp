// simreel report merge: combines several reports into one.
#include "base/error.hpp"
#include "base/log.hpp"
#include "cli/commands.hpp"
#include "cli/test/outputs.hpp"
#include "golden/report/merge.hpp"
#include "golden/tally.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

namespace fs = std::filesystem;

/// Fails if an input lies in the output folder, because the output folder is emptied first.
void checkApart(const fs::path& report, const fs::path& folder) {
  std::error_code unknown;
  const fs::path file = fs::weakly_canonical(report, unknown),
                 place = fs::weakly_canonical(folder, unknown);
  if (std::mismatch(place.begin(), place.end(), file.begin(), file.end()).first == place.end())
    fail(ExitCode::usage, "-o {} holds {}, which is to be merged; give another folder", folder.string(),
         report.string());
}

void merge(const std::vector<std::string>& reports, const TestOutputs& outputs) {
  if (outputs.github) avoidWorkflowCommands();
  std::vector<golden::PartReport> parts;
  for (const std::string& report : reports) {
    checkApart(report, outputs.report);
    parts.push_back(golden::readPart(report));
  }
  outputs.prepare();
  golden::Merged merged = golden::mergeReports(parts, outputs.report);
  merged.suite.command = commandLine();
  golden::Tally tally;
  for (const golden::SceneResult& scene : merged.suite.scenes)
    tally.add(scene.status, merged.suite.allowFlaky);
  if (merged.suite.strict && std::any_of(merged.suite.stale.begin(), merged.suite.stale.end(),
                                         [](const auto& one) { return !one.removed; }))
    tally.addFailure();
  outputs.write(merged.suite);
  ExitCode code = merged.suite.scenes.empty() ? ExitCode::ok : tally.exitCode();
  if (code == ExitCode::ok && !merged.missingShards.empty()) code = ExitCode::nothingRan;
  setExitCode(static_cast<int>(code));
}

}  // namespace

void addReport(CLI::App& app) {
  struct Arguments {
    std::vector<std::string> reports;
    TestOutputs outputs;
  };
  auto o = std::make_shared<Arguments>();
  auto* command = app.add_subcommand("report", "Work with reports of `simreel test`");
  command->require_subcommand(1);
  auto* merging = command->add_subcommand("merge",
                                          "Merge several reports, for example of --shard, into one; the "
                                          "exit code is as for one test of everything");
  merging->add_option("reports", o->reports, "Folders of --report, or files of --json")->required();
  merging->add_option("-o,--report", o->outputs.report, "Folder for the report and its pictures")
      ->required();
  o->outputs.addFiles(*merging);
  merging->callback([o] { merge(o->reports, o->outputs); });
}

}  // namespace simreel::cli
