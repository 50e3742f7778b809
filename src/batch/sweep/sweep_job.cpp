#include "batch/sweep/sweep_job.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/strict_json.hpp"
#include "batch/render/render_job.hpp"
#include "batch/render/scratch.hpp"
#include "batch/sweep/measurements.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/output_lock.hpp"
#include "frame/interrupt.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::batch {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path begunFile(const fs::path& folder) {
  return folder / "job.json";
}
fs::path resultFile(const fs::path& folder) {
  return folder / "result.json";
}

/// Returns the hash of the job that was begun in the folder, or an empty text if no job was begun.
std::string begunHash(const fs::path& folder) {
  if (!pathExists(begunFile(folder))) return {};
  try {
    const auto json = parseStrictJson(readFile(begunFile(folder), "job"));
    return JsonValue(json).at("hash").text();
  } catch (const JsonError&) {
    return {};
  } catch (const UserError&) {
    return {};
  }
}

std::optional<JobResult> storedResult(const SweepPlan& plan, std::size_t job) {
  const fs::path file = resultFile(plan.jobFolder(job));
  if (!pathExists(file)) return std::nullopt;
  try {
    JobResult result = parseResult(readFile(file, "result"), file.string());
    if (result.hash == plan.jobs[job].hash) return result;
  } catch (const UserError&) {  // NOLINT(bugprone-empty-catch): a damaged result counts as missing.
  }
  return std::nullopt;
}

/// Locks a job. Returns nullopt if another process holds the lock. The lock is in the shared folder even if
/// the job is drawn in a scratch folder.
std::optional<frame::OutputLock> lockOf(const SweepPlan& plan, std::size_t job) {
  const fs::path begun = begunFile(plan.jobFolder(job));
  makeFolders(plan.jobFolder(job));
  constexpr std::array all{0};
  try {
    return frame::OutputLock(begun, plan.jobs[job].hash, all);
  } catch (const UserError&) {
    if (!frame::isOutputLocked(begun)) throw;
    return std::nullopt;
  }
}

bool isRunning(const fs::path& folder) {
  return frame::isOutputLocked(begunFile(folder));
}

/// Removes everything in the folder except the lock.
void emptyFolder(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() != ".lock") all.push_back(entry.path());
  for (const fs::path& path : all) fs::remove_all(path, error);
}

/// True if the folder contains files although no job has begun in it.
bool holdsOthersFiles(const fs::path& folder) {
  std::error_code error;
  if (pathExists(begunFile(folder)) || pathExists(resultFile(folder))) return false;
  return std::any_of(fs::directory_iterator(folder, error), fs::directory_iterator(),
                     [](const auto& entry) {
                       const fs::path ending = entry.path().extension();
                       return ending != ".lock" && ending != ".part";
                     });
}

/// Marks the job as begun. First removes the files of another job with the same name, such as a job of an
/// earlier plan.
void begin(const SweepPlan& plan, std::size_t job) {
  const fs::path folder = plan.jobFolder(job);
  const std::string& hash = plan.jobs[job].hash;
  if (begunHash(folder) != hash) emptyFolder(folder);
  removeFile(resultFile(folder));
  Json values = Json::object();
  for (const scene::Override& value : plan.jobs[job].values) values[value.path] = value.value;
  const Json text = {{"job", job}, {"hash", hash}, {"values", values}};
  writeFileAtomically(begunFile(folder), text.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// Returns the last row of a table as pairs of column name and value.
std::vector<std::pair<std::string, std::string>> lastRow(const fs::path& table) {
  if (!pathExists(table)) return {};
  std::string text = readFile(table, "table of counts");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto cells = [](const std::string& line) {
    std::vector<std::string> parts(1);
    for (const char c : line)
      if (c == ',')
        parts.emplace_back();
      else
        parts.back() += c;
    return parts;
  };
  const auto names = cells(text.substr(0, text.find('\n')));
  const auto values = cells(text.substr(text.rfind('\n') + 1));
  std::vector<std::pair<std::string, std::string>> row;
  // The first two columns are step and time.
  for (std::size_t i = 2; i < std::min(names.size(), values.size()); ++i)
    row.emplace_back(names[i], values[i]);
  return row;
}

fs::path checksFile(const fs::path& folder) {
  return folder / "checks.part.json";
}

/// Returns the number of missing files among those that a done job's manifest lists. Does not read the
/// files.
std::size_t missingFiles(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    names.insert(entry.path().filename().string());
  std::size_t missing = 0;
  try {
    const auto manifest = frame::readManifest(folder / "manifest.json");
    if (!manifest) return 1;
    for (const auto& [number, frame] : manifest->frames) {
      missing += names.contains(frame.file) ? 0 : 1;
      for (const auto& [name, hash] : frame.files) missing += names.contains(name) ? 0 : 1;
    }
  } catch (const UserError&) {
    return 1;
  }
  return missing;
}

/// Renders the job into `folder`: the job's folder or a scratch folder.
void render(const SweepPlan& plan, std::size_t job, const gl::Context& context, frame::Progress& progress,
            const std::string& command, const fs::path& folder, JobEnd& end) {
  const auto began = Clock::now();
  RenderRequest request;
  request.input.file = plan.sceneFile();
  request.input.overrides = plan.overridesOf(job);
  request.input.assets = plan.assets;
  request.output = folder.string() + "/";
  if (!plan.frames.empty()) request.frames = plan.frames;
  if (!plan.fields.empty()) request.fields = plan.fields;
  request.existing = frame::Existing::resume;
  request.command = command;
  if (plan.sharedFrame && pathExists(plan.sharedCheckpoint())) request.from = plan.sharedCheckpoint();
  request.checkpointOptional = true;
  RenderJob rendering(std::move(request));
  if (jobHash(rendering.scene().hash, plan.frames, plan.fields) != plan.jobs[job].hash)
    fail(ExitCode::usage, "{} was changed after the sweep was planned; plan it again with --overwrite",
         plan.sceneFile().string());
  Measurements measurements(rendering.scene(), rendering.frames(), {checksFile(folder), checksFile(folder)},
                            [&](const golden::CheckResult& check) {
                              progress.check(check.what, check.frame, check.value, check.passed);
                            });
  const auto done = rendering.run(context, progress, began, &measurements);
  end.signal = done.signal;
  if (end.signal != 0) return;
  measurements.evaluateExisting([&](int frame) { return rendering.output().file(frame); });
  end.result.frames = done.frames;
  end.result.checks = measurements.checks();
  end.result.quantities = measurements.quantities();
  end.result.counts = lastRow(rendering.output().countFile());
}

}  // namespace

const char* stateName(JobState state) {
  switch (state) {
    case JobState::missing:
      return "missing";
    case JobState::queued:
      return "queued";
    case JobState::running:
      return "running";
    case JobState::aborted:
      return "aborted";
    case JobState::failed:
      return "failed";
    case JobState::done:
      break;
  }
  return "done";
}

JobStatus statusOf(const SweepPlan& plan, std::size_t job) {
  JobStatus status;
  status.result = storedResult(plan, job);
  const fs::path folder = plan.jobFolder(job);
  if (status.result) {
    status.state = status.result->code == 0 ? JobState::done : JobState::failed;
    const std::size_t missing = status.state == JobState::done ? missingFiles(folder) : 0;
    if (missing == 0) return status;
    status.result.reset();
    status.why =
        fmt::format("it was done, but {} of its files {} missing", missing, missing == 1 ? "is" : "are");
  }
  if (isRunning(folder))
    status.state = JobState::running;
  else if (begunHash(folder) == plan.jobs[job].hash)
    status.state = JobState::aborted;
  else
    status.state = JobState::missing;
  return status;
}

JobEnd runSweepJob(const SweepPlan& plan, std::size_t job, const gl::Context& context,
                   frame::Progress& progress, const std::string& command, const fs::path& scratch) {
  JobEnd end;
  end.result.hash = plan.jobs[job].hash;
  const fs::path folder = plan.jobFolder(job);
  std::optional<frame::OutputLock> lock;
  try {
    lock = lockOf(plan, job);
    if (!lock) {
      end.elsewhere = true;
      return end;
    }
    // The job may have been submitted twice, or another machine may have finished it in the meantime.
    if (auto stored = storedResult(plan, job); stored && stored->code == 0 && missingFiles(folder) == 0) {
      end.result = std::move(*stored);
      return end;
    }
    if (holdsOthersFiles(folder)) {
      end.result.code = static_cast<int>(ExitCode::inputOutput);
      end.result.message = fmt::format(
          "{} contains files that do not belong to a job; move them away, or choose another folder for the "
          "sweep",
          folder.string());
      return end;
    }
    begin(plan, job);
    Scratch place(folder, scratch);
    try {
      render(plan, job, context, progress, command, place.folder(), end);
    } catch (...) {
      place.deliver();
      throw;
    }
    place.deliver();
    if (end.signal != 0) return end;
    removeFile(checksFile(folder));
  } catch (const UserError& error) {
    end.signal = frame::interruptSignal();
    end.result.code = static_cast<int>(error.code());
    end.result.message = error.what();
  } catch (const std::bad_alloc&) {
    end.result.code = static_cast<int>(ExitCode::device);
    end.result.message = "not enough memory";
  }
  if (end.signal != 0) return end;
  try {
    writeFileAtomically(resultFile(folder), resultText(end.result));
  } catch (const UserError& error) {
    if (end.result.code != 0) return end;  // The first error remains, because it is the cause.
    end.result.code = static_cast<int>(error.code());
    end.result.message = error.what();
  }
  return end;
}

bool lacksShared(const SweepPlan& plan) {
  if (!plan.sharedFrame) return false;
  if (!pathExists(plan.sharedCheckpoint())) return true;
  try {
    static_cast<void>(frame::Checkpoint::load(plan.sharedCheckpoint()));
    return false;
  } catch (const UserError&) {
    return true;
  }
}

int makeShared(const SweepPlan& plan, const gl::Context& context, frame::Progress& progress,
               const std::string& command) {
  if (!lacksShared(plan)) return 0;
  RenderRequest request;
  request.input.file = plan.sceneFile();
  // The values of any job serve, because the varied values do not affect the simulation.
  request.input.overrides = plan.overridesOf(0);
  request.input.assets = plan.assets;
  request.output = plan.sharedFolder().string() + "/";
  request.frames = "none";
  request.checkpointAt = {*plan.sharedFrame};
  request.existing = frame::Existing::resume;
  request.command = command;
  return RenderJob(std::move(request)).run(context, progress, Clock::now()).signal;
}

JobResult writeLostResult(const SweepPlan& plan, std::size_t job, const std::string& how) {
  JobResult result;
  result.hash = plan.jobs[job].hash;
  result.code = static_cast<int>(ExitCode::device);
  result.message = fmt::format("the process that rendered it {}", how);
  makeFolders(plan.jobFolder(job));
  writeFileAtomically(resultFile(plan.jobFolder(job)), resultText(result));
  return result;
}

void removeOthers(const SweepPlan& old, const SweepPlan& next) {
  for (std::size_t job = 0; job < old.jobs.size(); ++job)
    if (isRunning(old.jobFolder(job)))
      fail(ExitCode::inputOutput, "{} is in use by another simreel process; wait for it, or end it first",
           old.jobFolder(job).string());
  std::error_code error;
  for (std::size_t job = 0; job < old.jobs.size(); ++job) {
    const fs::path folder = old.jobFolder(job);
    const bool stays = job < next.jobs.size() && old.name(job) == next.name(job) &&
                       begunHash(folder) == next.jobs[job].hash;
    if (!stays && pathExists(begunFile(folder))) fs::remove_all(folder, error);
  }
  fs::remove_all(old.sharedFolder(), error);
  for (const char* collected : {"table.csv", "counts.csv", "sheet.png", "index.html"})
    removeFile(old.folder / collected);
}

}  // namespace simreel::batch
