#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "batch/sweep/sweep_job.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::batch {

/// How many jobs of a sweep are where.
struct SweepTally {
  std::size_t done = 0, failed = 0, aborted = 0, running = 0, queued = 0, missing = 0;
  std::size_t checksFailed = 0;  ///< of those done

  void add(const JobStatus& status);
  [[nodiscard]] std::size_t jobs() const { return done + failed + aborted + running + queued + missing; }
  /// "24 jobs: 20 done (1 with failed checks), 3 failed, 1 missing".
  [[nodiscard]] std::string text() const;
  /// 1: one failed, or a check did; 7: one was begun or is queued and is not done; 3: one is missing; 0:
  /// all are done. The first of these that holds.
  [[nodiscard]] int exitCode() const;
};

/// How a sweep is run on this machine.
struct LocalRun {
  std::size_t workers = 1;
  gl::ContextOptions on;          ///< may list devices: each worker takes the next
  bool ndjson = false;            ///< an event on standard error for each check, and at the end of each job
  std::filesystem::path scratch;  ///< empty: jobs render into their own folders
  std::string command;
};

/// Runs jobs beside each other. Says how each ended. Returns the signal that interrupted it, or 0.
int runJobs(const SweepPlan& plan, const std::vector<std::size_t>& jobs, const LocalRun& how);

}  // namespace simreel::batch
