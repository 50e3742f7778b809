#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "batch/sweep/sweep_job.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// A sweep and the status of each of its jobs.
struct CollectedSweep {
  SweepPlan plan;
  std::vector<JobStatus> jobs;

  /// Returns the path of a job's picture at `frame`, or at its last frame if `frame` is nullopt. Empty if
  /// the job has no such picture.
  [[nodiscard]] std::filesystem::path pictureOf(std::size_t job, std::optional<int> frame) const;
};
[[nodiscard]] CollectedSweep collect(SweepPlan plan);

/// Returns a CSV table with a row for each job. Columns: job, state, each varied path, for each check its
/// value at its last frame and whether it passed at all its frames, each quantity at the last frame, and
/// each last count. Missing values are empty cells. The table has no machines or times, so it is the same
/// wherever the jobs ran.
[[nodiscard]] std::string tableText(const CollectedSweep& sweep);

/// Returns the count tables of all jobs as one CSV table, each row with its job first. Empty if no job
/// counts anything.
[[nodiscard]] std::string countsText(const CollectedSweep& sweep);

}  // namespace simreel::batch
