#include "batch/plan/sweep_plan.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/strict_json.hpp"
#include "base/version.hpp"
#include "batch/plan/plan_json.hpp"
#include "frame/file/output_name.hpp"
#include "frame/frames_spec.hpp"
#include "scene/as_run.hpp"
#include "scene/load.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <set>

#include <tbb/parallel_for.h>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;

constexpr const char* planFormat = "simreel-plan";
constexpr int planVersion = 1;

/// Parameter name that simulations use for the number of steps before the first frame.
constexpr const char* stepsBefore = "presteps";

/// Returns the frames that --frames selects. Without --frames, all frames are drawn, and only frame 0 is
/// returned.
std::vector<int> framesOf(const SweepPlan& plan, const scene::Scene& scene) {
  if (plan.frames.empty()) return {0};
  return frame::parseFrames(plan.frames, "--frames", scene.frameCount() - 1);
}

std::optional<int> sharedFrameOf(const SweepPlan& plan, const std::string& text) {
  if (plan.jobs.size() < 2 || std::any_of(plan.varied.begin(), plan.varied.end(), scene::touchesSimulation))
    return std::nullopt;
  const auto scene =
      scene::parseScene(text, plan.sceneFile(), plan.overridesOf(0), sim::kinds(), plan.assets);
  const int first = framesOf(plan, scene).front();
  const bool before = scene.time.start > 0 || first > 0 || text.find(stepsBefore) != std::string::npos ||
                      std::any_of(plan.overrides.begin(), plan.overrides.end(), [](const auto& change) {
                        return change.path.find(stepsBefore) != std::string::npos;
                      });
  return before ? std::optional(first) : std::nullopt;
}

SweepPlan parsePlan(const std::string& text) {
  const auto json = parseStrictJson(text);
  const JsonValue object(json);
  expectFormat(object, planFormat, planVersion);
  SweepPlan plan;
  plan.program = object.at("program").text();
  plan.assets = foldersIn(object.at("assets"));
  plan.overrides = overridesIn(object.at("overrides"));
  plan.frames = object.at("frames").text();
  plan.fields = object.at("fields").text();
  plan.varied = object.at("varied").texts();
  if (const JsonValue shared = object.at("sharedFrame"); !shared.isNull())
    plan.sharedFrame = shared.integer(0);
  object.at("jobs").eachItem([&](const JsonValue& item) {
    if (item.at("job").integer<std::int64_t>() != static_cast<std::int64_t>(plan.jobs.size()))
      item.wrong("does not have the number that follows that of the previous job");
    PlannedJob job;
    job.hash = item.at("hash").text();
    job.values = overridesIn(item.at("values"));
    if (job.values.size() != plan.varied.size()) item.wrong("must have one value for each varied path");
    plan.jobs.push_back(std::move(job));
  });
  if (plan.jobs.empty()) throw JsonError("it has no jobs");
  return plan;
}

}  // namespace

std::string SweepPlan::name(std::size_t job) const {
  const int digits = std::max<int>(4, static_cast<int>(std::to_string(jobs.size() - 1).size()));
  return fmt::format("{:0{}}", job, digits);
}

fs::path SweepPlan::jobFolder(std::size_t job) const {
  return folder / "jobs" / name(job);
}

std::vector<scene::Override> SweepPlan::overridesOf(std::size_t job) const {
  std::vector<scene::Override> all = overrides;
  all.insert(all.end(), jobs.at(job).values.begin(), jobs.at(job).values.end());
  return all;
}

fs::path SweepPlan::sharedCheckpoint() const {
  return frame::parseOutput(sharedFolder().string() + "/", 2).checkpointFile(sharedFrame.value_or(0));
}

std::string SweepPlan::label(std::size_t job) const {
  const std::vector<std::string> names = shortNames(varied);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}={}", i == 0 ? "" : " ", names[i], jobs.at(job).values[i].value);
  return text;
}

std::vector<std::string> shortNames(const std::vector<std::string>& paths) {
  // Each short name consists of the last k names of its path, with the smallest k that makes all short
  // names different.
  const auto lastNames = [](const std::string& path, int count) {
    std::size_t dot = path.size();
    for (int i = 0; i < count; ++i) {
      if (dot == 0) return path;
      dot = path.rfind('.', dot - 1);
      if (dot == std::string::npos) return path;
    }
    return path.substr(dot + 1);
  };
  std::vector<std::string> names;
  for (int count = 1; count <= 64; ++count) {
    names.clear();
    for (const std::string& path : paths) names.push_back(lastNames(path, count));
    if (std::set<std::string>(names.begin(), names.end()).size() == names.size()) break;
  }
  return names;
}

std::string jobHash(const std::string& sceneHash, const std::string& frames, const std::string& fields) {
  return hashHex(fmt::format("{} {} {} {}", version(), sceneHash, frames, fields));
}

void checkProgram(const SweepPlan& plan) {
  if (plan.program != version())
    fail(ExitCode::usage, "{} was written by simreel {}, this is {}; plan the sweep again with --overwrite",
         plan.planFile().string(), plan.program, version());
}

void checkJobs(SweepPlan& plan, const std::string& text) {
  std::mutex mutex;
  std::size_t firstBad = plan.jobs.size();
  std::exception_ptr mistake;
  const scene::Kinds& kinds = sim::kinds();
  tbb::parallel_for(std::size_t{0}, plan.jobs.size(), [&](std::size_t i) {
    try {
      const auto scene = scene::parseScene(text, plan.sceneFile(), plan.overridesOf(i), kinds, plan.assets);
      static_cast<void>(framesOf(plan, scene));
      plan.jobs[i].hash = jobHash(scene.hash, plan.frames, plan.fields);
    } catch (const UserError&) {
      const std::lock_guard lock(mutex);
      if (i >= firstBad) return;
      firstBad = i;
      mistake = std::current_exception();
    }
  });
  if (mistake) std::rethrow_exception(mistake);
  plan.sharedFrame = sharedFrameOf(plan, text);
}

std::string planText(const SweepPlan& plan) {
  std::string text =
      openObject({{"format", planFormat},
                  {"version", planVersion},
                  {"program", version()},
                  {"assets", folderList(plan.assets)},
                  {"frames", plan.frames},
                  {"fields", plan.fields},
                  {"overrides", overrideList(plan.overrides)},
                  {"varied", plan.varied},
                  {"sharedFrame", plan.sharedFrame ? PlanJson(*plan.sharedFrame) : PlanJson()}});
  text += ",\n  \"jobs\": [";
  for (std::size_t i = 0; i < plan.jobs.size(); ++i)
    text += (i == 0 ? "\n    " : ",\n    ") + lineOf({{"job", i},
                                                      {"folder", "jobs/" + plan.name(i)},
                                                      {"hash", plan.jobs[i].hash},
                                                      {"values", overrideList(plan.jobs[i].values)}});
  return text + "\n  ]\n}\n";
}

SweepPlan readSweepPlan(const fs::path& folder) {
  const fs::path file = folder / "plan.json";
  const std::string text = readPlan(file, "sweep");
  SweepPlan plan;
  try {
    plan = parsePlan(text);
  } catch (const JsonError& error) {
    fail(ExitCode::usage, "plan {} cannot be read: {}", file.string(), error.what());
  }
  plan.folder = folder;
  return plan;
}

}  // namespace simreel::batch
