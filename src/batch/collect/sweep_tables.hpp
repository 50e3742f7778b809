#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "batch/sweep/sweep_job.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simreel::batch {

/// A sweep and what has become of each of its jobs.
struct CollectedSweep {
  SweepPlan plan;
  std::vector<JobStatus> jobs;

  /// A job's picture of this frame, the last one that it has where none is named; empty where it has none.
  [[nodiscard]] std::filesystem::path pictureOf(std::size_t job, std::optional<int> frame) const;
};
[[nodiscard]] CollectedSweep collect(SweepPlan plan);

/// CSV, a row for each job: job, state, a column for each varied path, of each check its value at the last
/// of its frames and whether it passed at all of them, each quantity at the last frame, each last count.
/// What a job does not have is left empty. Machines and times are not in it: it is the same wherever the
/// jobs ran.
[[nodiscard]] std::string tableText(const CollectedSweep& sweep);

/// CSV of the tables of counts of all jobs, one below the other, each row with its job first; empty where
/// nothing counts.
[[nodiscard]] std::string countsText(const CollectedSweep& sweep);

}  // namespace simreel::batch
