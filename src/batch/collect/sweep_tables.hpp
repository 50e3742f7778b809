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

  /// Returns the path of a job's picture at `frame`, or at the job's last frame if `frame` is nullopt.
  /// Returns an empty path if the job has no such picture.
  [[nodiscard]] std::filesystem::path pictureOf(std::size_t job, std::optional<int> frame) const;
};
[[nodiscard]] CollectedSweep collect(SweepPlan plan);

/// Returns a CSV table with a row for each job. The columns are the job, the job's state, each varied path,
/// the value of each check at the check's last frame and whether the check passed at all its frames, each
/// quantity at the last frame, and each count at the last step. Missing values are empty cells. The table
/// contains no machines or times, so it is the same wherever the jobs ran.
[[nodiscard]] std::string tableText(const CollectedSweep& sweep);

/// Returns the count tables of all jobs as one CSV table. The first column of each row is the job. Returns
/// an empty text if no job counts anything.
[[nodiscard]] std::string countsText(const CollectedSweep& sweep);

}  // namespace simreel::batch
