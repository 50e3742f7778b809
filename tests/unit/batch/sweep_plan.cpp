#include "batch/plan/sweep_plan.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "batch/collect/sweep_tables.hpp"
#include "batch/plan/vary.hpp"
#include "batch/sweep/job_result.hpp"
#include "batch/sweep/sweep_run.hpp"
#include "frame/file/manifest.hpp"
#include "unit/frame/help.hpp"

#include <limits>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;
using namespace simreel::batch;
using simreel::frame::test::TemporaryFolder;

namespace {

constexpr const char* dish = R"({"version": 1, "objects": {"dish": {"grayScott": {"size": [16, 16]}}}})";

SweepPlan planIn(const std::string& folder) {
  SweepPlan plan;
  plan.folder = folder;
  plan.assets = {"/some where/else"};
  plan.overrides = {{"seed", "3"}};
  plan.frames = "0-3";
  plan.varied = {"objects.dish.grayScott.feed", "render.samples"};
  for (auto& values : combine({simreel::batch::parseVary("objects.dish.grayScott.feed=0.03,0.04"),
                               simreel::batch::parseVary("render.samples=1,4")},
                              Combination::grid, 0, 1))
    plan.jobs.push_back({std::move(values), {}});
  checkJobs(plan, dish);
  return plan;
}

}  // namespace

TEST_CASE("sweep: a plan is read back as written, one line per job") {
  const TemporaryFolder folder;
  const SweepPlan plan = planIn(folder.string());
  const std::string text = planText(plan);
  writeFileAtomically(plan.planFile(), text);
  const SweepPlan read = readSweepPlan(folder.string());
  CHECK(planText(read) == text);
  CHECK(read.overridesOf(2).size() == 3);
  CHECK(read.label(2) == "feed=0.04 samples=1");
  CHECK(read.jobFolder(2) == folder / "jobs/0002");
  CHECK(text.find("\n    {\"job\":2,\"folder\":\"jobs/0002\",\"hash\":\"") != std::string::npos);
  std::set<std::string> hashes;
  for (const PlannedJob& job : plan.jobs) hashes.insert(job.hash);
  CHECK(hashes.size() == 4);
  for (const auto& [from, to] : {std::pair("\"job\":2", "\"job\":3"),
                                 {"\"version\": 1", "\"version\": 2"},
                                 {"simreel-plan", "another"},
                                 {",\"render.samples=4\"", ""},
                                 {"]", ""}}) {
    std::string wrong = text;
    wrong.replace(wrong.find(from), std::string(from).size(), to);
    writeFileAtomically(plan.planFile(), wrong);
    CHECK_THROWS_WITH_AS(static_cast<void>(readSweepPlan(folder.string())),
                         doctest::Contains("plan.json cannot be read"), UserError);
  }
}

TEST_CASE("sweep: the first job with an error is reported") {
  SweepPlan plan;
  plan.varied = {"objects.dish.grayScott.feed"};
  for (const char* feed : {"0.03", "9", "\"much\""}) plan.jobs.push_back({{{plan.varied[0], feed}}, {}});
  CHECK_THROWS_WITH_AS(checkJobs(plan, dish), doctest::Contains("feed=9"), UserError);
}

TEST_CASE("sweep: names are as short as uniqueness allows") {
  using List = std::vector<std::string>;
  CHECK(shortNames({"objects.a.cloth.air", "objects.b.cloth.air"}) == List{"a.cloth.air", "b.cloth.air"});
  CHECK(shortNames({"seed"}) == List{"seed"});
  CHECK(shortNames({"a.seed", "seed"}) == List{"a.seed", "seed"});
  CHECK(shortNames({"render.samples", "seed"}) == List{"samples", "seed"});
}

TEST_CASE("sweep: results keep every digit, and distinguish missing from failed jobs") {
  const TemporaryFolder folder;
  const SweepPlan plan = planIn(folder.string());
  JobResult result;
  result.frames = 4;
  result.checks = {{"energy of flag", 3, 0.1 + 0.2, std::nullopt, 1.0 / 3, true, ""}};
  result.quantities = {{"mass of dish", "kg", 3, 1e-300},
                       {"lost", "", 3, std::numeric_limits<double>::quiet_NaN()}};
  result.counts = {{"town.ill", "12"}};
  const auto store = [&](std::size_t job, const JobResult& stored) {
    makeFolders(plan.jobFolder(job));
    writeFileAtomically(plan.jobFolder(job) / "result.json", resultText(stored));
  };
  result.hash = plan.jobs[0].hash;
  store(0, result);
  CHECK(statusOf(plan, 0).state ==
        JobState::missing);  // The job is missing, because no manifest lists its files.
  frame::Manifest manifest;
  manifest.frames[0].file = "000000.png";
  writeFileAtomically(plan.jobFolder(0) / "manifest.json", frame::manifestText(manifest));
  CHECK(statusOf(plan, 0).state ==
        JobState::missing);  // The job is missing, because the picture's file does not exist.
  writeFileAtomically(plan.jobFolder(0) / "000000.png", std::string("a picture"));
  CHECK(resultText(*statusOf(plan, 0).result) == resultText(result));
  result.hash = "of an earlier plan";
  store(1, result);
  result.hash = plan.jobs[2].hash;
  result.code = 4;
  result.message = "the state is lost";
  store(2, result);
  makeFolders(plan.jobFolder(3));
  writeFileAtomically(plan.jobFolder(3) / "job.json", "{\"hash\": \"" + plan.jobs[3].hash + "\"}");
  SweepTally tally;
  for (std::size_t i = 0; i < 4; ++i) tally.add(statusOf(plan, i));
  CHECK(tally.text() == "4 jobs: 1 done, 1 failed, 1 aborted, 1 missing");
  CHECK(tally.exitCode() == 1);
  CHECK(statusOf(plan, 1).state == JobState::missing);
  CHECK(statusOf(plan, 3).state == JobState::aborted);
  const std::string table = tableText(collect(plan));
  CHECK(
      table.starts_with("job,state,objects.dish.grayScott.feed,render.samples,check energy of flag,"
                        "passed energy of flag,mass of dish,lost,town.ill\n"
                        "0000,done,0.03,1,0.30000000000000004,yes,1e-300,,12\n"
                        "0001,missing,0.03,4,,,,,\n"));
  // Tests that a spreadsheet does not run cells as formulas. Their text comes from the author of a scene.
  for (const auto& [value, cell] :
       {std::pair("=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"), std::pair("@x,y", "\"'@x,y\""),
        std::pair("+x", "'+x"), std::pair("-1.5e3", "-1.5e3"), std::pair("-x", "'-x")}) {
    SweepPlan other = plan;
    other.jobs[1].values[0].value = value;
    CHECK(tableText(collect(other)).find(std::string("0001,missing,") + cell + ",4,") != std::string::npos);
  }
}

TEST_CASE("sweep: the exit code reflects failed and missing jobs") {
  const auto code = [](std::size_t done, std::size_t failed, std::size_t aborted, std::size_t missing,
                       std::size_t checksFailed) {
    SweepTally tally;
    tally.done = done;
    tally.failed = failed;
    tally.aborted = aborted;
    tally.missing = missing;
    tally.checksFailed = checksFailed;
    return tally.exitCode();
  };
  CHECK(code(9, 0, 0, 0, 0) == 0);
  CHECK(code(9, 0, 0, 0, 1) == 1);
  CHECK(code(9, 1, 1, 1, 0) == 1);
  CHECK(code(9, 0, 1, 1, 0) == 7);
  CHECK(code(9, 0, 0, 1, 0) == 3);
}
