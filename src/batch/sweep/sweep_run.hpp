#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "batch/sweep/sweep_job.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// Number of a sweep's jobs in each state.
struct SweepTally {
  std::size_t done = 0, failed = 0, aborted = 0, running = 0, queued = 0, missing = 0;
  std::size_t checksFailed = 0;  ///< number of done jobs with failed checks

  void add(const JobStatus& status);
  [[nodiscard]] std::size_t jobs() const { return done + failed + aborted + running + queued + missing; }
  /// Returns a summary: "24 jobs: 20 done (1 with failed checks), 3 failed, 1 missing".
  [[nodiscard]] std::string text() const;
  /// Returns the first exit code that applies. 1: a job or a check failed. 7: a job has begun or is queued
  /// but is not done. 3: a job is missing. 0: all jobs are done.
  [[nodiscard]] int exitCode() const;
};

/// Settings for running a sweep on this machine.
struct LocalRun {
  std::size_t workers = 1;
  gl::ContextOptions on;  ///< device selection; if it lists several devices, each worker takes the next one
  /// True to write an event to standard error for each check and at the end of each job.
  bool ndjson = false;
  /// Scratch folder on a local disk to render in. If empty, jobs render into their own folders.
  std::filesystem::path scratch;
  std::string command;
};

/// Runs jobs in parallel and reports how each ended. Returns the signal that interrupted the run, or 0.
int runJobs(const SweepPlan& plan, const std::vector<std::size_t>& jobs, const LocalRun& how);

}  // namespace simreel::batch
