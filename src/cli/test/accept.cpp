#include "golden/accept/accept.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace simreel::cli {

namespace {

void accept(const std::string& report, const golden::Acceptance& how) {
  const auto all = golden::acceptReport(report, how);
  if (all.empty())
    fail(ExitCode::nothingRan, "nothing to accept: {}",
         how.only.empty() ? "everything in the report passed" : "nothing that failed matches --only");
  int refused = 0;
  for (const golden::Accepted& one : all) {
    if (one.problem.empty()) {
      printText(fmt::format("{}  {}\n", one.already ? "already accepted" : "accepted", oneLine(one.scene)));
      continue;
    }
    ++refused;
    errorLine(fmt::format("simreel: error: {}: {}", one.scene, one.problem));
  }
  if (refused > 0) setExitCode(static_cast<int>(ExitCode::different));
}

}  // namespace

void addAccept(CLI::App& app) {
  struct Arguments {
    std::string report;
    golden::Acceptance how;
  };
  auto o = std::make_shared<Arguments>();
  auto* command = app.add_subcommand(
      "accept",
      "Turn the pictures and states of a test run into the new baselines, without rendering again");
  command->add_option("report", o->report, "report.json, or the folder of --report")->required();
  command
      ->add_option("--only", o->how.only,
                   "Only scenes or pictures whose name matches this pattern; repeatable")
      ->allow_extra_args(false);
  command->add_option("--reason", o->how.reason, "Reason, which the baselines of scenes keep");
  command->add_flag("--alternate", o->how.alternate,
                    "Add an alternative to a scene's baseline instead of replacing it");
  command->add_option("--expected", o->how.expected,
                      "Folder of the baselines of pictures (default: as tested)");
  command->add_option("--scenes", o->how.scenes, "Folder that the scenes must lie in (default: this one)");
  command->callback([o] { accept(o->report, o->how); });
}

}  // namespace simreel::cli
