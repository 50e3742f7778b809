#include "batch/sweep/sweep_run.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "base/workers.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/progress.hpp"
#include "gl/driver_threads.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace simreel::batch {

namespace {

constexpr int failedCode = 1, missingCode = 3, abortedCode = 7;

/// Answer of a worker if another process runs the job.
constexpr const char* elsewhere = "elsewhere";

void tell(const SweepPlan& plan, std::size_t job, const JobResult& result, std::size_t count,
          std::size_t all, const LocalRun& how) {
  if (how.ndjson) {
    const nlohmann::ordered_json event = {
        {"event", "job"},      {"job", plan.name(job)},     {"values", plan.label(job)},
        {"code", result.code}, {"message", result.message}, {"checksPassed", result.checksPassed()}};
    const frame::Progress progress(frame::Progress::Mode::ndjson);
    progress.event(event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  std::string end = "done";
  if (result.code != 0)
    end = fmt::format("failed ({}): {}", result.code, result.message);
  else if (!result.checksPassed())
    end = "done, but " + std::find_if(result.checks.begin(), result.checks.end(), [](const auto& check) {
                           return !check.passed;
                         })->message;
  info("[{}/{}] {} {}: {}", count, all, plan.name(job), plan.label(job), end);
}

}  // namespace

void SweepTally::add(const JobStatus& status) {
  switch (status.state) {
    case JobState::missing:
      ++missing;
      break;
    case JobState::queued:
      ++queued;
      break;
    case JobState::running:
      ++running;
      break;
    case JobState::aborted:
      ++aborted;
      break;
    case JobState::failed:
      ++failed;
      break;
    case JobState::done:
      ++done;
      if (!status.result->checksPassed()) ++checksFailed;
      break;
  }
}

std::string SweepTally::text() const {
  std::string text = fmt::format("{} job{}: {} done", jobs(), jobs() == 1 ? "" : "s", done);
  if (checksFailed > 0) text += fmt::format(" ({} with failed checks)", checksFailed);
  for (const auto& [count, word] : {std::pair(failed, "failed"),
                                    {aborted, "aborted"},
                                    {running, "running"},
                                    {queued, "queued"},
                                    {missing, "missing"}})
    if (count > 0) text += fmt::format(", {} {}", count, word);
  return text;
}

int SweepTally::exitCode() const {
  if (failed + checksFailed > 0) return failedCode;
  if (aborted + running + queued > 0) return abortedCode;
  return missing > 0 ? missingCode : 0;
}

namespace {

/// Simulates the common frames in a worker process, like a job. If the simulation fails, the jobs simulate
/// these frames themselves, so the error only causes a warning.
void shareWork(const SweepPlan& plan, const LocalRun& how) {
  WorkerPool force;
  force.items = 1;
  force.work = [&](WorkerLine& line) {
    const gl::Context context(how.on.ofWorker(line.place()));
    line.ready("");
    while (const auto task = line.next()) {
      frame::Progress progress(frame::Progress::Mode::none);
      if (const int signal = makeShared(plan, context, progress, how.command); signal != 0)
        throw frame::Interrupted{signal};
      line.answer(task->item, "");
    }
  };
  force.ready = [](const std::string& /*text*/) {};
  force.done = [](std::size_t /*item*/, const std::string& /*answer*/) {};
  force.lost = [](std::size_t /*item*/, const Loss& loss) {
    warn(
        "each job simulates the common beginning itself, because the process that simulated it for all "
        "jobs {}",
        loss.how);
  };
  force.alone = [](std::size_t /*item*/) { return false; };
  force.interrupted = [] { return frame::interruptSignal(); };
  runWorkers(force);
}

}  // namespace

int runJobs(const SweepPlan& plan, const std::vector<std::size_t>& jobs, const LocalRun& how) {
  if (jobs.size() > 1 && lacksShared(plan)) shareWork(plan, how);
  if (frame::interruptSignal() != 0) return frame::interruptSignal();
  WorkerPool force;
  force.workers = std::max<std::size_t>(1, std::min(how.workers, jobs.size()));
  force.items = jobs.size();
  if (force.workers > 1) gl::shareProcessors(force.workers);
  force.work = [&](WorkerLine& line) {
    const gl::Context context(how.on.ofWorker(line.place()));
    line.ready("");
    while (const auto task = line.next()) {
      frame::Progress progress(how.ndjson ? frame::Progress::Mode::ndjson : frame::Progress::Mode::none);
      progress.ofJob(plan.name(jobs[task->item]));
      const JobEnd end = runSweepJob(plan, jobs[task->item], context, progress, how.command, how.scratch);
      if (end.signal != 0) throw frame::Interrupted{end.signal};
      line.answer(task->item, end.elsewhere ? elsewhere : resultText(end.result));
    }
  };
  std::size_t count = 0;
  force.ready = [](const std::string& /*text*/) {};
  force.done = [&](std::size_t item, const std::string& text) {
    ++count;
    if (text == elsewhere)
      info("[{}/{}] {} {}: another simreel is rendering it", count, jobs.size(), plan.name(jobs[item]),
           plan.label(jobs[item]));
    else
      tell(plan, jobs[item], parseResult(text, "worker"), count, jobs.size(), how);
  };
  force.lost = [&](std::size_t item, const Loss& loss) {
    try {
      tell(plan, jobs[item], writeLostResult(plan, jobs[item], loss.how), ++count, jobs.size(), how);
    } catch (const UserError& error) {
      warn("{}: the process that rendered it {}, and {}", plan.name(jobs[item]), loss.how, error.what());
    }
  };
  force.alone = [](std::size_t /*item*/) { return false; };
  force.interrupted = [] { return frame::interruptSignal(); };
  runWorkers(force);
  return frame::interruptSignal();
}

}  // namespace simreel::batch
