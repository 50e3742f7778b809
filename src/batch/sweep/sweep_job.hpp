#pragma once
#include "batch/plan/sweep_plan.hpp"
#include "batch/sweep/job_result.hpp"
#include "frame/sink/progress.hpp"
#include "gl/context.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace simreel::batch {

/// Where a job of a sweep is.
enum class JobState {
  missing,  ///< nobody has begun it
  running,  ///< some process has its folder
  aborted,  ///< begun, and nobody is at it any more: it goes on from its checkpoint
  failed,   ///< ended with an error
  done
};
[[nodiscard]] const char* stateName(JobState state);

struct JobStatus {
  JobState state = JobState::missing;
  std::optional<JobResult> result;  ///< of a job that is done or failed
};
[[nodiscard]] JobStatus statusOf(const SweepPlan& plan, std::size_t job);

/// How this process's part in a job ended.
struct JobEnd {
  JobResult result;
  int signal = 0;  ///< that interrupted it; nothing is stored as its result then
};

/// Renders a job into its folder, or goes on with one that was interrupted there, and writes its result,
/// an error's too. `scratch`: a folder of this machine's own to render in; empty: none.
[[nodiscard]] JobEnd runSweepJob(const SweepPlan& plan, std::size_t job, const gl::Context& context,
                                 frame::Progress& progress, const std::string& command,
                                 const std::filesystem::path& scratch = {});
/// Simulates what all jobs share, if anything, and keeps its last state for them; they do without where it
/// is not there. Returns the signal that interrupted it, or 0. Throws UserError.
[[nodiscard]] int makeShared(const SweepPlan& plan, const gl::Context& context, frame::Progress& progress,
                             const std::string& command);
[[nodiscard]] bool lacksShared(const SweepPlan& plan);
/// For a job whose process ended before it could say how.
void writeLostResult(const SweepPlan& plan, std::size_t job, const std::string& how);

}  // namespace simreel::batch
